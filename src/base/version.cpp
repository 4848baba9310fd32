#include "coppice/version.h"

namespace coppice::inline v0 {

#define COPPICE_TEXT_OF(number) #number
#define COPPICE_TEXT(number) COPPICE_TEXT_OF(number)

Version version() noexcept {
    return {COPPICE_VERSION_MAJOR, COPPICE_VERSION_MINOR, COPPICE_VERSION_PATCH,
            COPPICE_TEXT(COPPICE_VERSION_MAJOR) "." COPPICE_TEXT(
                COPPICE_VERSION_MINOR) "." COPPICE_TEXT(COPPICE_VERSION_PATCH)};
}

}  // namespace coppice::inline v0
