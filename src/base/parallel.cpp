// Code that all tasking backends share. The rest is in tasking_tbb.cpp and tasking_serial.cpp.

#include "coppice/base/parallel.h"

#include "coppice/base/error.h"

#include <string>

namespace coppice::inline v0 {

void require_thread_count(int thread_count) {
    if (thread_count >= 0) return;
    throw Error(ErrorCode::invalid_argument,
                "threads must be 0 (all) or more, not " + std::to_string(thread_count));
}

}  // namespace coppice::inline v0
