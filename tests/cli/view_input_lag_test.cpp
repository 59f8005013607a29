// How long `prelight view` lets input wait: tests/window/session.sh asks a real window.
#include <gtest/gtest.h>
#include <view/input_lag.hpp>

namespace prelight::test {
namespace {

using app::viewer::InputLag;

TEST(InputLag, APictureThatCameWhileInputWaitedCounts) {
    InputLag lag;
    lag.look(); // nothing yet
    lag.show(1);
    lag.take(1); // came before that picture or after it
    lag.look();
    lag.show(2);
    EXPECT_EQ(lag.most(), 2u);
    EXPECT_EQ(lag.measured(), 1u);
    EXPECT_EQ(lag.pictures(), 2u);
}

TEST(InputLag, APictureOfTheSameStepDoesNotShowIt) {
    InputLag lag;
    lag.take(5);
    lag.look();
    lag.show(5);
    lag.take(5); // the older one is the one that waits
    lag.look();
    lag.show(5);
    EXPECT_EQ(lag.measured(), 0u);
    lag.show(6);
    EXPECT_EQ(lag.most(), 3u);
    lag.take(6);
    lag.look();
    lag.show(7);
    EXPECT_EQ(lag.most(), 3u) << "the longest wait";
    EXPECT_EQ(lag.measured(), 2u);
}

TEST(InputLag, WhatHasNoEffectIsNotWaitedFor) {
    InputLag lag;
    lag.take(3);
    lag.look();
    lag.rest(3); // its step is still to come
    lag.rest(4);
    for (int i = 0; i < 9; ++i)
        lag.show(10);
    EXPECT_EQ(lag.measured(), 0u);
}

} // namespace
} // namespace prelight::test
