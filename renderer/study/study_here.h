#pragma once
// A study where one stands: what it varies and how it draws is the study's, everything else that is true, scene and
// camera among it, is as it is now.
#include <string>
#include <vector>

#include "renderer/study/study_spec.h"

namespace gbl {

// Truth options that its cases differ in, by path.
std::vector<std::string> varied_truth(const StudySpec&);

// Does it ask something of whatever scene is at hand? Not if it moves the camera or compares scenes.
bool can_run_here(const StudySpec&);

StudySpec study_here(const StudySpec&, const Settings& now, glm::ivec2 size);

// The first truth option in which they differ, the size and those paths left out; "" = none.
std::string differing_truth(const Settings&, const Settings&, const std::vector<std::string>& varied);
inline bool same_truth_but(const Settings& a, const Settings& b, const std::vector<std::string>& varied) {
  return differing_truth(a, b, varied).empty();
}

}  // namespace gbl
