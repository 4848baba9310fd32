"""terminal.py RESULT COMMAND...: runs a command with stderr on a terminal of 100 columns and stdout
in RESULT.stdout, writes what the terminal got to RESULT, and ends with the command's code (128 +
its signal). With INTERRUPT set it presses Ctrl-C once the progress line shows that text."""


import fcntl, os, pty, struct, subprocess, sys, termios
master, slave = pty.openpty()
fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 100, 0, 0))


def take_terminal():
    os.setsid()
    fcntl.ioctl(slave, termios.TIOCSCTTY, 0)


with open(sys.argv[1] + ".stdout", "wb") as stdout:
    process = subprocess.Popen(sys.argv[2:], stdin=slave, stdout=stdout, stderr=slave,
                               preexec_fn=take_terminal)
os.close(slave)
seen = b""
interrupt = os.environ.get("INTERRUPT", "").encode()
while True:
    try:
        data = os.read(master, 65536)
    except OSError:
        break
    if not data:
        break
    seen += data
    if interrupt and interrupt in seen:
        os.write(master, b"\x03")
        interrupt = b""
open(sys.argv[1], "wb").write(seen)
code = process.wait()
sys.exit(128 - code if code < 0 else code)
