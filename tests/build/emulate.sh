#!/bin/sh
# Runs firmware on its emulated core: emulate.sh TARGET ELF. Output and exit status are the firmware's.
#
# With -icount virtual time counts instructions, at 2^shift ns each, so that an instruction takes more than a tick of
# the counter.
limit='timeout 300'

arm() {
  $limit qemu-system-arm -M "$1" -display none -serial none -monitor none -chardev stdio,id=out \
    -semihosting-config enable=on,target=native,chardev=out -icount shift=7 -kernel "$2" </dev/null
}

riscv() {
  $limit qemu-system-riscv32 -M virt -bios none -display none -serial stdio -monitor none -icount shift=0 -kernel "$1" \
    </dev/null
}

# simavr colours what the serial port says, ends its lines with a dot, and has no exit status.
avr() {
  said=$($limit simavr -m atmega2560 -f 16000000 "$1" 2>&1 | tr -d '\r' | sed 's/\x1b\[[0-9;]*m//g; s/\.$//')
  printf '%s\n' "$said" | grep -v -e '^exit ' -e '^Loaded' -e '^$'
  printf '%s\n' "$said" | grep -q '^exit 0'
}

case $1 in
  cortex-m0) arm microbit "$2" ;;
  cortex-m3) arm mps2-an385 "$2" ;;
  cortex-m4 | cortex-m4-fpu) arm mps2-an386 "$2" ;;
  cortex-m7 | cortex-m7-fpu) arm mps2-an500 "$2" ;;
  cortex-m33) arm mps2-an505 "$2" ;;
  rv32imc) riscv "$2" ;;
  avr) avr "$2" ;;
  *) echo "emulate: no board for $1" >&2; exit 2 ;;
esac
