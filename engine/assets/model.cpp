#include "engine/assets/model.h"

namespace rushlight::assets {

mat4 Node::localTransform() const {
    if (hasMatrix) return matrix;
    mat4 local = glm::mat4_cast(rotation);
    local[0] *= scale.x;
    local[1] *= scale.y;
    local[2] *= scale.z;
    local[3] = vec4(translation, 1);
    return local;
}

}  // namespace rushlight::assets
