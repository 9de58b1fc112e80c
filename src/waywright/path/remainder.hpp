// What is left of a path that is being driven.
#pragma once

#include "waywright/path/path.hpp"

namespace waywright {

/// The path from `driven` metres on, the same curves cut there; from a joint on what follows it. `driven` is clamped to what leaves a
/// piece, so that the path is never empty. A turn on the spot, which has no length, is left whole. Law: the length is what it was less
/// `driven`, up to rounding, and every place of it is one of the path's.
/// @pre the path is not empty
Path remainder(const Path& path, double driven);

}  // namespace waywright
