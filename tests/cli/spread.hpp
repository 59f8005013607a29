#pragma once
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace prelight::test {

/// `spread` is what every command writes for a time: its least, its median and its greatest.
inline void expect_spread(const nlohmann::json& spread) {
    ASSERT_EQ(spread.size(), 3u);
    EXPECT_GE(spread.at("min").get<double>(), 0);
    EXPECT_LE(spread.at("min").get<double>(), spread.at("median").get<double>());
    EXPECT_LE(spread.at("median").get<double>(), spread.at("max").get<double>());
}

} // namespace prelight::test
