#!/bin/busybox sh
# First and only program of the guest's own root: sets up buses, sound and the host's files, runs
# the command in them, says how it ended, switches the machine off.
/bin/busybox mkdir -p /proc /sys /dev /host
/bin/busybox --install -s /bin
mount -t proc none /proc
mount -t sysfs none /sys
mount -t devtmpfs none /dev
for module in /modules/*; do insmod "$module" || echo "guest: $module is refused"; done

ip link set lo up
for bus in vcan0 vcan1; do
  ip link add "$bus" type vcan
  ip link set "$bus" up
done

share() { mount -t 9p -o "trans=virtio,version=9p2000.L,msize=524288,$3" "$1" "$2"; }
share host /host ro,cache=loose
for kernel_tree in proc sys dev; do mount -o move "/$kernel_tree" "/host/$kernel_tree"; done
cd /host/dev
ln -s /proc/self/fd fd
ln -s fd/0 stdin
ln -s fd/1 stdout
ln -s fd/2 stderr
mkdir -p pts shm
mount -t devpts none pts

# The guest's own /tmp would hide a checkout that lies there: it is held and put back.
held=0
while read -r folder; do
  held=$((held + 1))
  mkdir -p "/held/$held"
  mount -o bind "/host$folder" "/held/$held"
done < /shown_folders
for own in /host/dev/shm /host/tmp /host/run; do mount -t tmpfs none "$own"; done
held=0
while read -r folder; do
  held=$((held + 1))
  [ -e "/host$folder" ] && continue
  mkdir -p "/host$folder"
  mount -o bind "/held/$held" "/host$folder"
done < /shown_folders
work=$(cat /work_folder)
mkdir -p "/host$work"
share work "/host$work" rw

stty -F /host/dev/ttyS1 raw
chroot /host /bin/bash "$work/.vm/command" < /host/dev/null > /host/dev/ttyS1 2>&1
echo $? > "/host$work/.vm/status"
stty -F /host/dev/ttyS1 raw  # waits until the last of the output has left
printf '\0' | dd of=/host/dev/port bs=1 seek=244 2> /host/dev/null  # the exit device: QEMU ends
