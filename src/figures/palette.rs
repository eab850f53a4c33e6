use super::scene::Ink;

/// The colours of a picture, red, green and blue.
#[derive(Clone, Copy, Debug)]
pub struct Palette {
    paper: [u8; 3],
    text: [u8; 3],
    faint: [u8; 3],
    grid: [u8; 3],
    series: [[u8; 3]; SERIES],
}

/// How many colours there are for curves.
pub const SERIES: usize = 8;

impl Palette {
    /// On white.
    ///
    /// The hues are those of Okabe and Ito (*Color Universal Design*, 2008), which are told apart with every common
    /// kind of colour blindness; some are darkened, so that all stand out from the paper.
    pub const LIGHT: Palette = Palette {
        paper: [0xff, 0xff, 0xff],
        text: [0x22, 0x22, 0x22],
        faint: [0x59, 0x59, 0x59],
        grid: [0xdd, 0xdd, 0xdd],
        series: [
            [0x00, 0x6b, 0xab],
            [0xc2, 0x4e, 0x00],
            [0x00, 0x7a, 0x5a],
            [0xa8, 0x3f, 0x7d],
            [0x8f, 0x6a, 0x00],
            [0x1d, 0x84, 0xbf],
            [0x55, 0x55, 0x55],
            [0x7a, 0x4f, 0x2a],
        ],
    };

    /// On a dark page: the same hues, lighter.
    pub const DARK: Palette = Palette {
        paper: [0x16, 0x19, 0x1d],
        text: [0xe8, 0xe8, 0xe8],
        faint: [0xb4, 0xb8, 0xbd],
        grid: [0x3a, 0x3f, 0x46],
        series: [
            [0x5c, 0xb8, 0xf0],
            [0xf5, 0x92, 0x4e],
            [0x35, 0xc9, 0x9c],
            [0xe3, 0x94, 0xc6],
            [0xe8, 0xc5, 0x4a],
            [0x9a, 0xd4, 0xf7],
            [0xc4, 0xc4, 0xc4],
            [0xd0, 0xa2, 0x78],
        ],
    };

    /// The colour for a purpose; curves beyond the last begin again.
    pub fn colour(&self, ink: Ink) -> [u8; 3] {
        match ink {
            Ink::Paper => self.paper,
            Ink::Text => self.text,
            Ink::Faint => self.faint,
            Ink::Grid => self.grid,
            Ink::Series(at) => self.series[at % SERIES],
        }
    }
}
