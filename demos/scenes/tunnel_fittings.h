// The parts that stand in the tunnel or are bolted to it.
#pragma once

#include "demos/scenes/tunnel_body.h"

namespace clearway::scenes {

/// Adds ribs, guides and mounts, the heater duct, propeller shaft and exhaust, pipes, hoses and cables,
/// straps, brackets, bolts, weld nuts and studs.
void addTunnelFittings(TunnelBody& body, int studs);

}  // namespace clearway::scenes
