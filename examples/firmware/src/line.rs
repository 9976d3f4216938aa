//! Lines of text for whoever watches.

use semihosting::io::{self, Write};

/// A line that is being written. What does not fit into it is left out.
pub struct Line {
    text: [u8; Self::MOST],
    length: usize,
}

impl Line {
    /// The longest has so many bytes.
    const MOST: usize = 1024;
    /// So much room a word takes, with a space before it.
    const LONGEST_WORD: usize = 64;

    /// An empty one.
    pub const fn new() -> Self {
        Self { text: [0; Self::MOST], length: 0 }
    }

    fn push(&mut self, byte: u8) {
        if let Some(place) = self.text.get_mut(self.length) {
            *place = byte;
            self.length += 1;
        }
    }

    /// Adds this.
    pub fn text(&mut self, text: &str) -> &mut Self {
        for byte in text.bytes() {
            self.push(byte);
        }
        self
    }

    /// Adds a space and a number in the decimal system.
    pub fn number(&mut self, number: u32) -> &mut Self {
        self.push(b' ');
        let mut unit = 1_000_000_000;
        while unit > 1 && number < unit {
            unit /= 10;
        }
        let mut remainder = number;
        for _ in 0..10 {
            let mut digit = b'0';
            while remainder >= unit {
                remainder -= unit;
                digit += 1;
            }
            self.push(digit);
            if unit == 1 {
                break;
            }
            unit /= 10;
        }
        self
    }

    /// Adds a space and a word.
    pub fn name(&mut self, name: &str) -> &mut Self {
        self.push(b' ');
        self.text(name)
    }

    /// Adds a space and these bits as sixteen hexadecimal digits.
    pub fn bits(&mut self, bits: u64) -> &mut Self {
        self.push(b' ');
        for digit in (0..16).rev() {
            let digit = (bits >> (4 * digit)) as u8 & 15;
            self.push(if digit < 10 { b'0' + digit } else { b'a' - 10 + digit });
        }
        self
    }

    /// Prints what stands in it so far where hardly any place is left, and goes on with the same line.
    ///
    /// # Errors
    /// If nobody listens.
    pub fn make_room(&mut self) -> io::Result<()> {
        if self.length + Self::LONGEST_WORD < Self::MOST {
            return Ok(());
        }
        self.write()
    }

    /// Prints it.
    ///
    /// # Errors
    /// If nobody listens.
    pub fn print(&mut self) -> io::Result<()> {
        self.push(b'\n');
        self.write()
    }

    fn write(&mut self) -> io::Result<()> {
        let text = self.text.get(..self.length).unwrap_or_default();
        io::stdout()?.write_all(text)?;
        self.length = 0;
        Ok(())
    }
}
