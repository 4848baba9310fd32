#pragma once

#include "coppice/builders/build_control.h"
#include "coppice/builders/build_report.h"

#include "text/progress_line.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace coppice::app {

/// Runs a build, or more of them: the progress line shows `what` and how far it is, Ctrl-C and
/// SIGTERM stop it. Throws Interrupted then.
void watch_build(lab::ProgressLine& progress, const std::string& what, const BuildControl& limits,
                 const std::function<void(const BuildControl&)>& build);

/// Says on standard error that a memory limit led to another preset, if it did.
void note_preset(const BuildReport& report);

/// Says on standard error which options of a build had no effect on this scene, but for those that
/// the method has by itself.
void note_vain_options(std::span<const BuildNote> notes, std::string_view method,
                       std::uint32_t primitive_count);

}  // namespace coppice::app
