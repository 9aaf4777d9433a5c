'use strict';

// splitmix64, as tests/support/random.h.
class Random {
  constructor(seed) { this.word = BigInt(seed); }

  u32() {
    this.word = BigInt.asUintN(64, this.word + 0x9E3779B97F4A7C15n);
    let z = this.word;
    z = BigInt.asUintN(64, (z ^ (z >> 30n)) * 0xBF58476D1CE4E5B9n);
    z = BigInt.asUintN(64, (z ^ (z >> 27n)) * 0x94D049BB133111EBn);
    return (z ^ (z >> 31n)) >> 32n;
  }

  below(bound) { return Number(this.u32() * BigInt(bound) >> 32n); }
  range(low, high) { return Number(this.u32() * BigInt(high - low + 1) >> 32n) + low; }
  vector(size) { return [0, 1, 2].map(() => this.range(-size, size)); }
}

module.exports = { Random };
