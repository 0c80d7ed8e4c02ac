"""A small machine with real SocketCAN and real ALSA, on a host that has neither, nor KVM, nor root.

Its clock is virtual: it counts instructions and jumps while idle. A busy host makes a test slow, never late.
The guest sees the host's files read-only, and one folder it may write; /tmp, /run and /dev/shm are its own, but for
the folders that are to be shown.
"""
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

from vm.kernel import kernel_folder

HERE = pathlib.Path(__file__).parent


TIMED_OUT = 124


class CannotStart(Exception):
    """The machine did not come as far as running the command."""


def build_initrd(kernel, work, shown, scratch):
    root = scratch / 'root'
    (root / 'bin').mkdir(parents=True)
    shutil.copy('/bin/busybox', root / 'bin')
    shutil.copytree(kernel / 'modules', root / 'modules')
    shutil.copy(HERE / 'guest_init.sh', root / 'init')
    (root / 'init').chmod(0o755)
    (root / 'work_folder').write_text(str(work))
    (root / 'shown_folders').write_text(''.join(f'{folder}\n' for folder in shown))
    names = '\n'.join(str(p.relative_to(root)) for p in sorted(root.rglob('*')))
    archive = scratch / 'initrd'
    with archive.open('wb') as out:
        subprocess.run(['cpio', '--quiet', '-o', '-H', 'newc'], input=names.encode(), cwd=root, stdout=out, check=True)
    return archive


def share(tag, path, *options):
    quoted = str(path).replace(',', ',,')
    return ['-virtfs', ','.join([f'local,mount_tag={tag},path={quoted},security_model=none,multidevs=remap', *options])]


def qemu_command(kernel, initrd, work, console):
    return ['qemu-system-x86_64', '-accel', 'tcg', '-icount', 'shift=1,sleep=off', '-machine', 'q35', '-cpu', 'max',
            '-m', '1024', '-nodefaults', '-display', 'none', '-monitor', 'none', '-net', 'none', '-no-reboot',
            '-kernel', kernel / 'vmlinux', '-initrd', initrd, '-append',
            'console=ttyS0 quiet panic=-1 mitigations=off nokaslr cryptomgr.notests nohz=off',
            '-serial', f'file:{console}', '-serial', 'stdio', '-device', 'isa-debug-exit,iobase=0xf4,iosize=4',
            *share('host', '/', 'readonly=on'), *share('work', work)]


def run(work, command, limit_s, shown):
    """Runs `command` (a list) in the guest, in the folder `work`; returns its exit status, or TIMED_OUT.

    `shown`: absolute paths of folders it reads, wherever they lie.
    """
    work = pathlib.Path(work).resolve()
    control = work / '.vm'
    shutil.rmtree(control, ignore_errors=True)
    control.mkdir()
    (control / 'command').write_text(f'cd {shlex.quote(str(work))}\nexec {shlex.join(map(str, command))}\n')
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        console = scratch / 'console'
        try:
            kernel = kernel_folder()
            words = qemu_command(kernel, build_initrd(kernel, work, shown, scratch), work, console)
            subprocess.run(words, stdin=subprocess.DEVNULL, timeout=limit_s)
        except subprocess.TimeoutExpired:
            print(f'the machine did not end within {limit_s} s', file=sys.stderr)
            return TIMED_OUT
        except (OSError, RuntimeError, subprocess.CalledProcessError) as error:
            raise CannotStart(f'{error} {getattr(error, "stderr", "") or ""}') from error
        status = control / 'status'
        if status.exists() and status.read_text().strip():
            return int(status.read_text())
        kernel_log = console.read_text(errors='replace') if console.exists() else ''
        raise CannotStart('the guest ended without a word; its console said:\n' + kernel_log[-3000:])
