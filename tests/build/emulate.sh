#!/bin/sh
# Runs firmware on its emulated core: emulate.sh TARGET ELF. The exit status is the firmware's.
# One tick of the board's counter is a fixed part of an instruction: virtual time counts instructions.
qemu_arm() {
  timeout 300 qemu-system-arm -M "$1" -nographic -monitor none -serial null -semihosting -icount shift=7 -kernel "$2"
}
case $1 in
  cortex-m0) qemu_arm microbit "$2" ;;
  cortex-m3) qemu_arm mps2-an385 "$2" ;;
  cortex-m4) qemu_arm mps2-an386 "$2" ;;
  cortex-m7) qemu_arm mps2-an500 "$2" ;;
  cortex-m33) qemu_arm mps2-an505 "$2" ;;
  rv32imc) timeout 300 qemu-system-riscv32 -M virt -nographic -monitor none -bios none -icount shift=0 -kernel "$2" ;;
  avr)
    # simavr colours what the serial port says, ends its lines with a dot, and has no exit status.
    out=$(timeout 300 simavr -m atmega2560 -f 16000000 "$2" 2>&1 | sed 's/\x1b\[[0-9;]*m//g; s/\.$//' | tr -d '\r')
    printf '%s\n' "$out" | grep -v '^exit\|^Loaded\|^$'
    printf '%s\n' "$out" | grep -q '^exit 0' ;;
  *) echo "emulate: no board for $1" >&2; exit 2 ;;
esac
