// Motions: channels of keys, each driving one property of one node.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/math/id.h"
#include "core/math/transform.h"
#include "core/mesh/array.h"

namespace mw {

/// Immutable once in a clip; an edit replaces one channel and shares the others. Times in seconds, ascending, finite, not negative.
struct Channel {
    enum class Path : uint8_t {
        Translation,  ///< 3 numbers, replaces the node's
        Rotation,     ///< quaternion x y z w, replaces the node's; Linear means the shorter arc (SLERP)
        Scale,        ///< 3 numbers
        Weights,      ///< of morph targets, one a target
        PositionX,
        PositionY,
        PositionZ,  ///< 1 number, added to the node's rest translation (BVH)
        EulerX,
        EulerY,
        EulerZ  ///< 1 angle in degrees, not wrapped; those of a node multiply in the order of the clip (BVH)
    };
    enum class Interpolation : uint8_t { Linear, Step, Cubic };

    NodeId node;
    Path path = Path::Translation;
    Interpolation interpolation = Interpolation::Linear;
    int components = 3;     ///< numbers a value
    Shared<double> times;   ///< often one array for all channels
    Shared<double> values;  ///< `components` a key; Cubic: in-tangent, value and out-tangent of each key, as in glTF
    size_t keys() const { return times.size(); }
};

/// The order of the channels is that of the file; of Euler channels it is the order of rotation.
struct Clip {
    std::string name;
    std::vector<std::shared_ptr<const Channel>> channels;
    double frameTime = 0;  ///< seconds a frame where a file says so (BVH); 0: unknown
};
/// The time of the last key; 0 when there is none.
double duration(const Clip& c);
size_t keyCount(const Clip& c);
/// Of channels; those shared are counted each time.
size_t byteSize(const Clip& c);
uint64_t contentHash(const Clip& c);

/// The value of a channel at a time, `components` numbers into `out`; before the first and after the last key it holds; of
/// keys at one time the last counts. Rotations are unit. A channel without keys leaves `out` as it is.
void sample(const Channel& c, double time, double* out);
/// A node's transform at a time, from its rest and the channels that drive it, in clip order. Weights channels are passed over. Angles replace
/// the rest's rotation.
Transform sampled(const Transform& rest, std::span<const Channel* const> channels, double time);

}  // namespace mw
