#pragma once
// points.jsonl: every point of the sweeps as it was measured, so that a run that was stopped goes on where it was, and
// several machines share one.
#include <string>

#include "renderer/study/stability/stability.h"

namespace gbl {

// Names a point among all sweeps: "near-plane/depth d24/0.001/" and a hash of its settings.
std::string point_key(const Sweep&, const Curve&, double value, const Settings&);

StudyRow journal_row(const std::string& key, const SweepRow&, const Settings&, const std::string& made_by);
SweepRow point_of(const StudyRow&);  // what journal_row() was made of

// What a point of a journal must be made by to count. The device and what is switched off are part of it: statements are
// about one device.
std::string sweeps_made_by(const Machine&, FeatureSet);

}  // namespace gbl
