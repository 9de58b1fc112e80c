// What is left of a path that is being driven, and what lies before a place of it.
#pragma once

#include "waywright/path/path.hpp"

namespace waywright {

/// The path from `driven` metres on, the same curves cut there; from a joint on what follows it. `driven` is clamped to what leaves a
/// piece, so that the path is never empty. A turn on the spot, which has no length, is left whole. Law: the length is what it was less
/// `driven`, up to rounding, and every place of it is one of the path's.
/// @pre the path is not empty
Path remainder(const Path& path, double driven);

/// The path up to `s` metres, the same curves cut there. `s` is clamped to what leaves a piece; at a joint it ends with what comes before it. A turn on the spot is
/// whole or not there. Law: with the remainder from the same place on it is the path, up to rounding.
/// @pre the path is not empty
Path beginning(const Path& path, double s);

}  // namespace waywright
