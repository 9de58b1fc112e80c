// What a plan that leads around something says of its way, held against the way that it comes in place of.
#pragma once

#include <string>
#include <vector>

#include "waywright/path/path.hpp"

namespace waywright {

/// "TITLE: it is 16.235 m long …" of each sentence; what was proven of a part alone is no matter any more and is left out.
std::vector<std::string> of_part(const char* title, const std::vector<std::string>& sentences);

/// A way as it is driven. Both samples are with s from its beginning and t.
struct DrivenWay {
  const std::vector<Sample>& samples;
  double time = 0.0;  ///< s, that it takes
  const char* remark = "";  ///< behind the time, " if nothing moved"
};

/// Where the new way leaves the old one, where it joins it again (where it is within 2 cm of it from there to its end), how much longer it is and takes.
/// `left_at`: m, up to which both are the same. @pre neither is empty, and they begin at the same place
std::string detour_sentence(const DrivenWay& old, const DrivenWay& now, double left_at);

}  // namespace waywright
