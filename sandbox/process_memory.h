#pragma once

namespace rushlight {

/// Lets this process keep up to half a gigabyte of what it frees instead of handing it back to the
/// system, which would have to map and clear it again. llvmpipe frees and allocates what it bins in
/// every frame: on page faults alone it spent a fifth of the time of the thread that draws. Does
/// nothing but with glibc. A program's choice, so no library calls it.
void keepFreedMemory();

}  // namespace rushlight
