//! Residues modulo one prime: what does not hold for them does not hold for the numbers.

/// The Mersenne prime 2³¹ − 1: the product of two residues fits in 64 bits.
pub(super) const PRIME: u64 = (1 << 31) - 1;

/// The product.
pub(super) fn times(a: u64, b: u64) -> u64 {
    a * b % PRIME
}

/// A power.
pub(super) fn power(mut base: u64, mut exponent: u64) -> u64 {
    let mut product = 1;
    while exponent > 0 {
        if exponent % 2 == 1 {
            product = times(product, base);
        }
        base = times(base, base);
        exponent /= 2;
    }
    product
}

/// `1 / a` of what is not 0, by Fermat's little theorem.
pub(super) fn inverse(a: u64) -> u64 {
    match a {
        1 => 1,
        a => power(a, PRIME - 2),
    }
}
