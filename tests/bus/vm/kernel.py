"""Debian's own kernel and the few modules the bus tests need, fetched once into a cache."""
import os
import pathlib
import shutil
import subprocess
import tempfile

MODULES = ['virtio_pci', '9pnet_virtio', '9p', 'can-raw', 'can-gw', 'can-j1939', 'vcan', 'snd-hrtimer', 'snd-aloop',
           'snd-dummy']


def cache_folder():
    root = os.environ.get('RIGSOUND_VM_CACHE') or pathlib.Path.home() / '.cache' / 'rigsound-vm'
    return pathlib.Path(root)


def output_of(*words, **options):
    return subprocess.run(words, check=True, capture_output=True, text=True, **options).stdout


def package_name():
    for line in output_of('apt-cache', 'depends', 'linux-image-amd64').splitlines():
        if 'Depends:' in line:
            return line.split()[-1]
    raise RuntimeError('linux-image-amd64 names no kernel package: run apt-get update')


def bare_kernel(image):
    """The ELF inside a bzImage: it starts at once, where the image would unpack itself in emulation."""
    data = image.read_bytes()
    at = data.find(b'\xfd7zXZ\0')
    elf = subprocess.run(['xz', '-dc', '--single-stream'], input=data[at:], stdout=subprocess.PIPE,
                         stderr=subprocess.DEVNULL).stdout
    if at < 0 or elf[:4] != b'\x7fELF':
        raise RuntimeError(f'{image.name} holds no xz-packed kernel')
    return elf


def module_files(tree, version):
    files = []
    for module in MODULES:
        for line in output_of('/sbin/modprobe', '-d', tree, '-S', version, '--show-depends', module).splitlines():
            words = line.split()
            if words[0] == 'insmod' and words[1] not in files:
                files.append(words[1])
    return files


def fetch(target):
    package = package_name()
    version = package.removeprefix('linux-image-')
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        output_of('apt-get', '-qq', 'download', package, cwd=scratch)
        tree, ready = scratch / 'tree', scratch / 'ready'
        output_of('dpkg-deb', '-x', next(scratch.glob('*.deb')), tree)
        output_of('/sbin/depmod', '-b', tree, version)
        (ready / 'modules').mkdir(parents=True)
        (ready / 'vmlinux').write_bytes(bare_kernel(tree / 'boot' / f'vmlinuz-{version}'))
        for number, file in enumerate(module_files(tree, version)):
            shutil.copy(file, ready / 'modules' / f'{number:02}-{pathlib.Path(file).name}')
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.move(ready, target)


def kernel_folder():
    """Folder with `vmlinux` and `modules/`, the latter in the order they must be loaded."""
    folder = cache_folder() / 'kernel'
    if not (folder / 'vmlinux').exists():
        fetch(folder)
    return folder
