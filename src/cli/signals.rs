//! Purpose: give what the system ends a process for the program's own message and exit code.
//!
//! Method: where memory is at its end the process is aborted by a signal. Its handler may neither print nor take
//! memory, so it wakes a thread that waits for that from the start, and then waits itself, by writing into a pipe
//! that is full, till that thread has said what happened and has ended the process.
//!
//! Limits: before the signal the runtime of the language prints a line of its own, `memory allocation of … bytes
//! failed`, and where several threads meet the end at once these are torn into each other. What would silence them is
//! not stable (`set_alloc_error_hook`) or not safe (an allocator of one's own). The program's own line comes after
//! them, whole and in one write, and is the only one that begins with `error: `.

/// The exit code of what could not be computed.
#[cfg(unix)]
const NOT_COMPUTED: i32 = 3;
/// It begins with a line's end, since a thread that met the same end may have been cut off within a line of its own.
#[cfg(unix)]
const SAYS: &[u8] =
    b"\nerror: the work could not go on: as a rule, the memory that the system gives is not enough\n";
/// The thread calls a few functions of the system.
#[cfg(unix)]
const STACK: usize = 64 << 10;

/// Sets the handlers. Where one cannot be set, the process ends by the signal.
#[cfg(unix)]
pub fn handle() {
    use signal_hook::consts::{SIGABRT, SIGXFSZ};
    use signal_hook::flag;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};
    // a file that grows too long is then an error of the write, and what was begun is taken away
    let _ = flag::register(SIGXFSZ, Arc::new(AtomicBool::new(false)));
    // till there is a thread to say it, and where there is none, the exit code is right at least
    let unsaid = Arc::new(AtomicBool::new(true));
    let _ = flag::register_conditional_shutdown(SIGABRT, NOT_COMPUTED, Arc::clone(&unsaid));
    unsaid.store(say_at_abort().is_err(), Ordering::SeqCst);
}

/// Nothing is to be handled here.
#[cfg(not(unix))]
pub fn handle() {}

#[cfg(unix)]
fn say_at_abort() -> std::io::Result<()> {
    use signal_hook::{consts::SIGABRT, low_level};
    use std::fs::File;
    use std::io::{Read, Write, pipe};
    use std::os::fd::{AsFd, OwnedFd};
    use std::os::unix::net::UnixStream;

    // a descriptor of its own, since standard error may be locked by who was aborted
    let mut error = File::from(std::io::stderr().as_fd().try_clone_to_owned()?);
    let (mut woken, mut wakes) = UnixStream::pair()?;
    let (never_read, mut full) = pipe()?;
    let wait = move || {
        if woken.write_all(&[0]).is_ok() && woken.read_exact(&mut [0]).is_ok() {
            let _ = error.write_all(SAYS);
            low_level::exit(NOT_COMPUTED);
        }
        // without its reader the pipe blocks nobody
        drop(never_read);
    };
    std::thread::Builder::new().stack_size(STACK).spawn(wait)?;
    // the thread is there and takes no more memory
    wakes.read_exact(&mut [0])?;
    low_level::pipe::register(SIGABRT, wakes)?;
    // registering makes the pipe fail where it would block; it is filled to that point, and blocks from then on
    low_level::pipe::register(SIGABRT, full.try_clone()?)?;
    while full.write(&[0; 512]).is_ok() {}
    while full.write(&[0]).is_ok() {}
    UnixStream::from(OwnedFd::from(full)).set_nonblocking(false)
}
