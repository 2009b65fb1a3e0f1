#pragma once
// What a command line gives to sweeps: a scene of one's own where a sweep can use one, and options over those that the
// sweep has. What is stated of a curve is stated of the sweep's own scene: with anything given nothing is judged.
#include <functional>
#include <string>
#include <vector>

#include "renderer/study/stability/stability.h"

namespace gbl {

struct SweepGiven {
  Settings settings;                    // as `render` would draw them
  std::shared_ptr<const Scene> scene;   // of these settings, where one of the next two is true
  bool place = false;                   // a scene, a camera or lights are given: no sweep may pass over them
  bool state = false;                   // a state says where one stands: sweeps that make their own scene pass over it
  bool ways = false;                    // a preset or a state says how to draw
  std::vector<std::string> paths = {};  // options that are given by themselves
  std::string words = {};               // as typed
};

// Is this option part of where one stands: the scene, its camera, its lights?
bool is_place(std::string_view path);

// Why the sweep cannot take it; "" = it can. What a sweep varies or needs cannot be given.
std::string refusal(const Sweep&, const SweepGiven&);

// Changes a point of the sweep before its curve is applied. The sweep must take what is given.
std::function<void(SweepSetup&)> given_over(const Sweep&, const SweepGiven&);

}  // namespace gbl
