//! The supervisor of a program that plays a match, see `carom_arena::supervise`.

fn main() -> std::io::Result<()> {
    #[cfg(target_os = "linux")]
    return carom_arena::supervise();
    #[cfg(not(target_os = "linux"))]
    Err(std::io::ErrorKind::Unsupported.into())
}
