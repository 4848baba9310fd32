#pragma once

#include <string>
#include <vector>

namespace coppice::app {

/// Lets commands read scenes from pipes as they read files: a scene called "-" becomes
/// "/dev/stdin", and what comes in by that, or by "/dev/fd/N" as shells name `<(command)`, is put
/// into a temporary file without a name, which takes its place. Throws Error(io).
void take_piped_scenes(std::vector<std::string>& scenes);

}  // namespace coppice::app
