//! The frames that a viewer shows of a file.

use std::io::Cursor;

/// The frames of an animation as they are seen, in red, green, blue and opacity; and the time of each.
pub(crate) type Film = Vec<(Vec<[u8; 4]>, u32)>;

/// The frames of a GIF, put one over the other as its specification says; delays in hundredths of a second.
pub(crate) fn gif(bytes: &[u8]) -> Film {
    let mut decoder = gif::DecodeOptions::new().read_info(bytes).expect("a GIF");
    let global = decoder.global_palette().expect("a table for all").to_vec();
    let [width, height] = [decoder.width(), decoder.height()].map(usize::from);
    let mut canvas = vec![[0; 4]; width * height];
    let mut film = Vec::new();
    while let Some(frame) = decoder.read_next_frame().expect("a frame") {
        let table = frame.palette.as_ref().unwrap_or(&global);
        let (table, _) = table.as_chunks::<3>();
        let rows = frame.buffer.chunks(frame.width.into());
        for (row, y) in rows.zip(usize::from(frame.top)..) {
            for (&entry, x) in row.iter().zip(usize::from(frame.left)..) {
                if frame.transparent != Some(entry) {
                    let [red, green, blue] = table[usize::from(entry)];
                    canvas[y * width + x] = [red, green, blue, 255];
                }
            }
        }
        film.push((canvas.clone(), frame.delay.into()));
    }
    assert_eq!(decoder.repeat(), gif::Repeat::Infinite);
    film
}

/// The frames of an animated PNG, likewise; delays in thousandths of a second.
pub(crate) fn apng(bytes: &[u8]) -> Film {
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().expect("a PNG");
    let control = reader.info().animation_control.expect("an animation");
    assert_eq!(control.num_plays, 0);
    let width = reader.info().width as usize;
    let mut canvas = vec![[0; 4]; width * reader.info().height as usize];
    let mut film = Vec::new();
    for _ in 0..control.num_frames {
        let mut bytes = vec![0; reader.output_buffer_size().expect("a size")];
        let info = reader.next_frame(&mut bytes).expect("a frame");
        let samples = info.color_type.samples();
        let frame = *reader.info().frame_control().expect("of an animation");
        assert_eq!(frame.dispose_op, png::DisposeOp::None);
        assert_eq!(frame.delay_den, 1000);
        let rows = bytes[..info.buffer_size()].chunks(info.line_size);
        for (row, y) in rows.zip(frame.y_offset as usize..) {
            for (pixel, x) in row.chunks(samples).zip(frame.x_offset as usize..) {
                let alpha = pixel.get(3).copied().unwrap_or(255);
                let pixel = [pixel[0], pixel[1], pixel[2], alpha];
                let is_over = frame.blend_op == png::BlendOp::Over;
                match alpha {
                    0 if is_over => {}
                    1..=254 if is_over => panic!("nothing is to be mixed"),
                    _ => canvas[y * width + x] = pixel,
                }
            }
        }
        film.push((canvas.clone(), frame.delay_num.into()));
    }
    film
}
