"""Build and check every file of a release: ``make release``."""
