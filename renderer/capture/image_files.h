#pragma once

#include "engine/core/result.h"
#include "renderer/capture/picture.h"

#include <cstddef>
#include <string>
#include <vector>

namespace rushlight {

enum class ImageFormat : uint8_t { png, jpeg, exr };

enum class EncodeEffort : uint8_t {
    none,  ///< as fast as can be: PNG and EXR are not compressed (JPEG: as `fast`)
    fast,
    small,  ///< PNG and EXR: the same pixels in fewer bytes; JPEG: quality 88 with colours at half
            ///< the size
};

/// By the extension (.png, .jpg, .jpeg, .exr; case does not matter). ErrorKind::wrongUse for
/// another one.
Result<ImageFormat> imageFormatOf(const std::string& path);

/// The bytes of a file; equal pictures give equal bytes (no date, no host name).
///     png   8 bit sRGB, straight alpha; without the alpha channel when all is opaque
///     jpeg  8 bit sRGB over black, quality 95
///     exr   linear, premultiplied alpha; without the alpha channel when all is opaque; half
///     floats, or
///           floats when a value does not fit into a half
/// `name` is for messages. ErrorKind::wrongUse when the format cannot hold this kind of picture.
Result<std::vector<std::byte>> encodeImage(const std::string& name, ImageFormat, const PictureView&,
                                           EncodeEffort = EncodeEffort::fast);

/// encodeImage and writeFile: a file is there whole or as it was before.
Result<void> saveImage(const std::string& path, const PictureView&,
                       EncodeEffort = EncodeEffort::fast);

/// Any format that OpenImageIO reads, of at most 16,384 pixels a side.
Result<Picture> loadPicture(const std::string& path);

}  // namespace rushlight
