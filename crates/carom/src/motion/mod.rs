//! Closed-form paths between events.
