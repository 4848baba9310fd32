#include "tracers/variant.h"

#include "coppice/base/error.h"

#include <gtest/gtest.h>

namespace coppice::lab {

namespace {

TEST(Variant, IsAMethodWithItsOwnSampleOrAnother) {
    EXPECT_EQ(sample_of(find_variant("sampled").options).rate, 0.01);
    EXPECT_EQ(sample_of(find_variant("exact").options).rate, 1.0);
    const Variant variant = find_variant("fast@12.5%");
    EXPECT_EQ(variant.method, "fast");
    EXPECT_EQ(tree_kind(variant.options), TreeKind::bvh8);
    EXPECT_EQ(sample_of(variant.options).rate, 0.125);
    EXPECT_EQ(sample_of(variant.options).sampler,
              find_method("fast").bvh8_options().sample.sampler);
    EXPECT_EQ(sample_of(find_variant(variant_name("quality", 0.3)).options).rate, 0.003);
}

TEST(Variant, RefusesOtherNames) {
    for (const char* name : {"", "best", "best@1%", "fast@", "fast@%", "fast@1", "fast@0%",
                             "fast@101%", "fast@-1%", "fast@nan%", "fast@1%%", "fast@1 %"}) {
        EXPECT_THROW(static_cast<void>(find_variant(name)), Error) << name;
    }
}

}  // namespace

}  // namespace coppice::lab
