//! The script is allowed by its hash: here it is computed from FIPS 180-4 anew.

use super::page_of;

pub(super) fn sha256(bytes: &[u8]) -> Vec<u8> {
    let primes: Vec<u32> = (2..312).filter(|n| (2..*n).all(|d| n % d != 0)).collect();
    // The first 32 bits of the fractional part of a root, by whole numbers: floor(root · 2^32).
    let root = |prime: u32, degree: u32| -> u32 {
        let scaled = |x: u128| match degree {
            2 => x * x <= u128::from(prime) << 64,
            _ => x * x * x <= u128::from(prime) << 96,
        };
        let (mut low, mut high) = (0u128, 1u128 << 37);
        while high - low > 1 {
            let middle = (low + high) / 2;
            match scaled(middle) {
                true => low = middle,
                false => high = middle,
            }
        }
        (low & 0xffff_ffff) as u32
    };
    let constants: Vec<u32> = primes.iter().take(64).map(|&p| root(p, 3)).collect();
    let mut state: Vec<u32> = primes.iter().take(8).map(|&p| root(p, 2)).collect();
    let mut padded = bytes.to_vec();
    padded.push(0x80);
    while padded.len() % 64 != 56 {
        padded.push(0);
    }
    padded.extend((bytes.len() as u64 * 8).to_be_bytes());
    for block in padded.chunks(64) {
        let mut words: Vec<u32> = block
            .chunks(4)
            .map(|c| u32::from_be_bytes(c.try_into().unwrap()))
            .collect();
        for at in 16..64 {
            let (a, b) = (words[at - 15], words[at - 2]);
            let small = a.rotate_right(7) ^ a.rotate_right(18) ^ (a >> 3);
            let large = b.rotate_right(17) ^ b.rotate_right(19) ^ (b >> 10);
            words.push(
                words[at - 16]
                    .wrapping_add(small)
                    .wrapping_add(words[at - 7])
                    .wrapping_add(large),
            );
        }
        let mut s = state.clone();
        for at in 0..64 {
            let large = s[4].rotate_right(6) ^ s[4].rotate_right(11) ^ s[4].rotate_right(25);
            let choice = (s[4] & s[5]) ^ (!s[4] & s[6]);
            let sum = [s[7], large, choice, constants[at], words[at]];
            let first = sum.into_iter().fold(0u32, u32::wrapping_add);
            let large = s[0].rotate_right(2) ^ s[0].rotate_right(13) ^ s[0].rotate_right(22);
            let majority = (s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]);
            s.rotate_right(1);
            s[4] = s[4].wrapping_add(first);
            s[0] = first.wrapping_add(large).wrapping_add(majority);
        }
        state
            .iter_mut()
            .zip(s)
            .for_each(|(own, more)| *own = own.wrapping_add(more));
    }
    state.iter().flat_map(|word| word.to_be_bytes()).collect()
}

pub(super) fn base64(bytes: &[u8]) -> String {
    let letters = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for chunk in bytes.chunks(3) {
        let all = (0..3).fold(0u32, |all, at| {
            all << 8 | u32::from(*chunk.get(at).unwrap_or(&0))
        });
        for at in 0..4 {
            match at <= chunk.len() {
                true => text.push(char::from(letters[(all >> (18 - 6 * at) & 63) as usize])),
                false => text.push('='),
            }
        }
    }
    text
}

#[test]
fn the_policy_allows_this_script_and_no_other() {
    // The example of the standard.
    assert_eq!(
        base64(&sha256(b"abc")),
        "ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0="
    );
    let page = page_of(&[]);
    let script = page
        .split("<script>")
        .nth(1)
        .unwrap()
        .split("</script>")
        .next()
        .unwrap();
    let hash = base64(&sha256(script.as_bytes()));
    assert!(
        page.contains(&format!("script-src 'sha256-{hash}'")),
        "the hash is now sha256-{hash}"
    );
}
