#pragma once

#include <string>
#include <vector>

namespace coppice::app {

/// Lets commands read a scene from standard input as they read files: a scene called "-" becomes
/// "/dev/stdin", and if that is named and no file, all that comes in is put into a temporary file
/// without a name, which takes its place. Throws Error(io).
void take_standard_input(std::vector<std::string>& scenes);

}  // namespace coppice::app
