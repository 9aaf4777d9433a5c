// Random numbers and hashes as those of tests/support, and what the arguments of a program say.

pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed)
    }

    pub fn u32(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 32) as u32
    }

    pub fn below(&mut self, bound: u32) -> u32 {
        (u64::from(self.u32()) * u64::from(bound) >> 32) as u32
    }

    #[allow(dead_code)]
    pub fn range(&mut self, low: i32, high: i32) -> i32 {
        let span = (i64::from(high) - i64::from(low) + 1) as u64;
        (i64::from(low) + (u64::from(self.u32()) * span >> 32) as i64) as i32
    }
}

/// Compares a hash with that of the arguments COUNT HASH. The exit status.
#[allow(dead_code)]
pub fn judge(hash_of: impl Fn(u32) -> u64) -> i32 {
    let arguments: Vec<String> = std::env::args().collect();
    let hash = hash_of(arguments[1].parse().unwrap());
    println!("{:016x}", hash);
    i32::from(hash != u64::from_str_radix(&arguments[2], 16).unwrap())
}
