//! The methods that all pictures have in common.

/// The size, the colours and the view of a picture, and its name and size for [`Debug`](core::fmt::Debug): nobody wants to read the
/// pixels.
macro_rules! picture {
    ($Picture:ident, $name:literal, $pixel:ty) => {
        impl<M: Memory> $Picture<M> {
            /// The width in pixels.
            #[must_use]
            pub fn width(&self) -> usize {
                self.pixels.size()[0]
            }

            /// The height in pixels.
            #[must_use]
            pub fn height(&self) -> usize {
                self.pixels.size()[1]
            }

            /// The rows of pixels.
            #[allow(dead_code, reason = "without features only frames are read by rows")]
            pub(crate) const fn grid(&self) -> &M::Pixels<$pixel> {
                &self.pixels
            }

            /// The colours.
            #[must_use]
            pub const fn palette(&self) -> &Palette {
                &self.palette
            }

            /// The part of the scene that is seen.
            #[must_use]
            pub const fn view(&self) -> View {
                self.view
            }

            /// Changes the part of the scene that is seen, for what is painted from now on.
            pub const fn look_at(&mut self, view: View) {
                self.view = view;
            }
        }

        impl<M: Memory> fmt::Debug for $Picture<M> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let [width, height] = self.pixels.size();
                write!(f, "{}{}<{width}, {height}>", M::PREFIX, $name)?;
                f.debug_struct("").field("view", &self.view).finish_non_exhaustive()
            }
        }
    };
}

/// A picture on the heap that looks at a whole mechanism.
#[cfg(feature = "std")]
macro_rules! picture_of_mechanism {
    ($Picture:ident) => {
        impl $Picture {
            /// An empty picture of this width and height in pixels that shows all of a mechanism, wherever its motors move it.
            ///
            /// # Errors
            /// [`TooLarge`] if a side exceeds 2²¹ pixels, or if there is no memory for the pixels.
            pub fn of<A: Mechanism>(width: usize, height: usize) -> Result<Self, TooLarge> {
                let mut picture = Self::new(width, height)?;
                picture.look_at(A::view(width, height));
                Ok(picture)
            }
        }
    };
}

pub(super) use picture;
#[cfg(feature = "std")]
pub(super) use picture_of_mechanism;
