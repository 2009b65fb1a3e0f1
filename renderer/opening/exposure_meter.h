#pragma once
// The exposure that shows what the lights do: metered on the surfaces that the camera sees, by the reference's own
// shading, without any driver.
#include <optional>

#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"

namespace gbl {

// Rounded to a third of a stop. Empty: no light reaches a surface that is seen.
std::optional<double> metered_exposure(const Settings&, const Scene&);

// Sets the exposure; ambient light and a backdrop of one colour keep their share of the display. False: nothing was
// there to meter, and nothing has changed.
bool meter(Settings&, const Scene&);

// The exposure, and with it ambient light and backdrop.
void set_exposure(Settings&, double exposure);

}  // namespace gbl
