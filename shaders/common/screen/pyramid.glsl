// Where the levels of a pyramid are in its one image: level 0 is half the frame's size (w x h), each other half of the one
// before it. P is h rounded up to a multiple of 16.
//
//     x    0              w          w + w/2
//     y  0 +--------------+-------------+
//          |   level 0    |   level 1   |
//          |              +------+------+ P / 2
//          |              |  2   |
//          |              +---+--+        3 P / 4
//        h +--------------+...            up to level 4
//
// flatRight.w, flatUp.w: w and h.
#define PYRAMID_LEVELS 5

ivec2 pyramidOrigin(int level) {
    int padded = (int(flatUp.w) + 15) & ~15;
    return level == 0 ? ivec2(0) : ivec2(int(flatRight.w), padded - (padded >> (level - 1)));
}
