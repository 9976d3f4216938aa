//! Stand-ins for what is on a board: buses, pins, a counter and a delay, and two displays that remember what they were sent.
//!
//! They have the traits of `embedded-hal`, as those of a board crate (`stm32f4xx-hal`, `rp2040-hal`, `nrf52840-hal`, `esp-hal` …):
//!
//! | here | on a board |
//! |---|---|
//! | [`St7789::spi`] | the SPI and its chip-select pin, as one device: `embedded_hal_bus::spi::ExclusiveDevice` |
//! | [`St7789::data_pin`], [`Quiet`] | a pin as output |
//! | [`Ssd1306::i2c`] | the I²C, at 400 kHz |
//! | [`Quiet`] as a delay | a timer |
//! | [`Counter`] | a timer in encoder mode: its counter register |

use crate::Line;
use core::cell::Cell;
use core::convert::Infallible;
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::{self, OutputPin};
use embedded_hal::i2c::{self, I2c};
use embedded_hal::spi::{self, SpiDevice};

/// A pin or a delay that does nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Quiet;

impl digital::ErrorType for Quiet {
    type Error = Infallible;
}

impl OutputPin for Quiet {
    fn set_low(&mut self) -> Result<(), Infallible> {
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

impl DelayNs for Quiet {
    fn delay_ns(&mut self, _: u32) {}
}

/// The counter of a quadrature encoder on a shaft that turns evenly. It has sixteen bits and wraps around.
#[derive(Clone, Debug)]
pub struct Counter {
    value: u16,
    speed: i16,
}

impl Counter {
    /// One that counts so much (backwards, if it is negative) from one reading to the next.
    #[must_use]
    pub const fn new(speed: i16) -> Self {
        Self { value: 0, speed }
    }

    /// Reads it.
    pub const fn read(&mut self) -> u16 {
        self.value = self.value.wrapping_add_signed(self.speed);
        self.value
    }
}

/// What goes into the memory of a display is written into a window of it, column by column and row by row.
struct Window {
    columns: Cell<[u16; 2]>,
    rows: Cell<[u16; 2]>,
    at: Cell<[u16; 2]>,
}

impl Window {
    const fn new() -> Self {
        Self { columns: Cell::new([0; 2]), rows: Cell::new([0; 2]), at: Cell::new([0; 2]) }
    }

    fn begin(&self) {
        self.at.set([self.columns.get()[0], self.rows.get()[0]]);
    }

    /// The column and the row that are next.
    fn next(&self) -> [u16; 2] {
        let place = self.at.get();
        let [column, row] = place;
        let ([left, right], [top, bottom]) = (self.columns.get(), self.rows.get());
        self.at.set(if column < right {
            [column + 1, row]
        } else if row < bottom {
            [left, row + 1]
        } else {
            [left, top]
        });
        place
    }
}

/// A display of 240 × 240 pixels with an ST7789, which understands the commands that write pixels.
pub struct St7789 {
    is_data: Cell<bool>,
    command: Cell<u8>,
    /// The last bytes after it, and how many there were.
    last: Cell<u32>,
    count: Cell<u32>,
    window: Window,
    pixels: [[Cell<u16>; Self::SIDE]; Self::SIDE],
    sent: Cell<u32>,
}

impl St7789 {
    /// Its width and height, in pixels.
    pub const SIDE: usize = 240;

    const COLUMNS: u8 = 0x2a;
    const ROWS: u8 = 0x2b;
    const PIXELS: u8 = 0x2c;

    /// One that is all black.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            is_data: Cell::new(false),
            command: Cell::new(0),
            last: Cell::new(0),
            count: Cell::new(0),
            window: Window::new(),
            pixels: [const { [const { Cell::new(0) }; Self::SIDE] }; Self::SIDE],
            sent: Cell::new(0),
        }
    }

    /// The bus at whose end it is.
    pub const fn spi(&self) -> Spi<'_> {
        Spi(self)
    }

    /// The pin that tells data from commands.
    pub const fn data_pin(&self) -> DataPin<'_> {
        DataPin(self)
    }

    /// How many bytes were sent since this was asked last.
    pub fn sent_bytes(&self) -> u32 {
        self.sent.take()
    }

    /// The colour of a pixel, as it was sent; black, where there is none.
    pub fn pixel(&self, x: usize, y: usize) -> u16 {
        let row = self.pixels.get(y);
        row.and_then(|row| row.get(x)).map_or(0, Cell::get)
    }

    /// Prints what it shows: four pixels a word.
    pub fn print(&self) {
        for row in &self.pixels {
            for part in row.chunks(row.len() / 2) {
                let words = part.chunks(4).map(|pixels| {
                    let join = |word, pixel: &Cell<u16>| word << 16 | u64::from(pixel.get());
                    pixels.iter().fold(0, join)
                });
                print("st7789", words);
            }
        }
    }

    fn take(&self, byte: u8) {
        if !self.is_data.get() {
            self.command.set(byte);
            self.count.set(0);
            if byte == Self::PIXELS {
                self.window.begin();
            }
            return;
        }
        let last = self.last.get() << 8 | u32::from(byte);
        let count = self.count.get().wrapping_add(1);
        self.last.set(last);
        self.count.set(count);
        let range = [(last >> 16) as u16, last as u16];
        match self.command.get() {
            Self::COLUMNS if count == 4 => self.window.columns.set(range),
            Self::ROWS if count == 4 => self.window.rows.set(range),
            Self::PIXELS if count.is_multiple_of(2) => {
                let [x, y] = self.window.next().map(usize::from);
                if let Some(pixel) = self.pixels.get(y).and_then(|row| row.get(x)) {
                    pixel.set(last as u16);
                }
            }
            _ => {}
        }
    }
}

impl Default for St7789 {
    fn default() -> Self {
        Self::new()
    }
}

/// The bus at whose end an ST7789 is.
pub struct Spi<'w>(&'w St7789);

impl spi::ErrorType for Spi<'_> {
    type Error = Infallible;
}

impl SpiDevice for Spi<'_> {
    fn transaction(&mut self, operations: &mut [spi::Operation<'_, u8>]) -> Result<(), Infallible> {
        for operation in operations {
            if let spi::Operation::Write(bytes) = operation {
                for byte in *bytes {
                    self.0.sent.set(self.0.sent.get().wrapping_add(1));
                    self.0.take(*byte);
                }
            }
        }
        Ok(())
    }
}

/// The pin by which an ST7789 tells data from commands.
pub struct DataPin<'w>(&'w St7789);

impl digital::ErrorType for DataPin<'_> {
    type Error = Infallible;
}

impl OutputPin for DataPin<'_> {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.is_data.set(false);
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.is_data.set(true);
        Ok(())
    }
}

/// A display of 128 × 64 pixels with an SSD1306, which understands the commands that write pixels. A byte is eight pixels, the upper
/// ones in its low bits; a page is a row of bytes.
pub struct Ssd1306 {
    window: Window,
    pages: [[Cell<u8>; Self::WIDTH]; Self::PAGES],
    sent: Cell<u32>,
}

impl Ssd1306 {
    /// Its width, in pixels.
    pub const WIDTH: usize = 128;
    const PAGES: usize = 8;

    const COMMAND: u8 = 0x00;
    const DATA: u8 = 0x40;
    const COLUMNS: u8 = 0x21;
    const ROWS: u8 = 0x22;

    /// One that is all dark.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            window: Window::new(),
            pages: [const { [const { Cell::new(0) }; Self::WIDTH] }; Self::PAGES],
            sent: Cell::new(0),
        }
    }

    /// The bus at whose end it is.
    pub const fn i2c(&self) -> Bus<'_> {
        Bus(self)
    }

    /// How many bytes were sent since this was asked last, each message with its address.
    pub fn sent_bytes(&self) -> u32 {
        self.sent.take()
    }

    /// Whether a pixel is lit.
    pub fn is_lit(&self, x: usize, y: usize) -> bool {
        let page = self.pages.get(y / 8);
        let byte = page.and_then(|page| page.get(x)).map_or(0, Cell::get);
        byte >> (y % 8) & 1 != 0
    }

    /// Prints what it shows: a page a line, eight bytes a word.
    pub fn print(&self) {
        for page in &self.pages {
            let words = page.chunks(8).map(|bytes| {
                let join = |word, byte: &Cell<u8>| word << 8 | u64::from(byte.get());
                bytes.iter().fold(0, join)
            });
            print("ssd1306", words);
        }
    }

    fn take(&self, message: &[u8]) {
        let count = u32::try_from(message.len()).unwrap_or(u32::MAX);
        self.sent.set(self.sent.get().wrapping_add(count).wrapping_add(1));
        match *message {
            [Self::COMMAND, Self::COLUMNS, first, last] => {
                self.window.columns.set([first, last].map(u16::from));
                self.window.begin();
            }
            [Self::COMMAND, Self::ROWS, first, last] => {
                self.window.rows.set([first, last].map(u16::from));
                self.window.begin();
            }
            [Self::DATA, ref data @ ..] => {
                for byte in data {
                    let [x, page] = self.window.next().map(usize::from);
                    if let Some(place) = self.pages.get(page).and_then(|page| page.get(x)) {
                        place.set(*byte);
                    }
                }
            }
            _ => {}
        }
    }
}

impl Default for Ssd1306 {
    fn default() -> Self {
        Self::new()
    }
}

/// The bus at whose end an SSD1306 is.
pub struct Bus<'w>(&'w Ssd1306);

impl i2c::ErrorType for Bus<'_> {
    type Error = Infallible;
}

impl I2c for Bus<'_> {
    fn transaction(
        &mut self,
        _: u8,
        operations: &mut [i2c::Operation<'_>],
    ) -> Result<(), Infallible> {
        for operation in operations {
            if let i2c::Operation::Write(message) = operation {
                self.0.take(message);
            }
        }
        Ok(())
    }
}

/// Prints a line of words. If nobody listens, nothing is to be done.
fn print(name: &str, words: impl Iterator<Item = u64>) {
    let mut line = Line::new();
    line.text(name);
    for word in words {
        line.bits(word);
    }
    let _ = line.print();
}
