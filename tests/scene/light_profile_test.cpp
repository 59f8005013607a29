// IES files: what is read, the symmetries, and every way in which a file can be wrong.
#include "gltf_builder.hpp"
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/error.hpp>
#include <prelight/light_distribution.hpp>
#include <scene/procedural/cookie_maps.hpp>

namespace prelight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A file with these horizontal angles; candela at column c and row r is 100 c + 10 r + 1.
std::string file(const std::vector<double>& horizontal,
                 const std::string& head = "IESNA:LM-63-2002\n[TEST] a\nTILT=NONE\n") {
    std::string text = head + "1 -1 2 3 " + std::to_string(horizontal.size()) + " 1 2 0 0 0\n0.5 1 10\n0 45 90\n";
    for (const double angle : horizontal)
        text += std::to_string(angle) + " ";
    for (size_t c = 0; c < horizontal.size(); ++c)
        for (int r = 0; r < 3; ++r)
            text += "\n" + std::to_string(100 * c + 10 * size_t(r) + 1);
    return text + "\n";
}

/// The candela of the first row at each horizontal angle.
std::vector<double> first_row(const LightProfile& profile) {
    std::vector<double> out;
    for (size_t c = 0; c < profile.horizontal.size(); ++c)
        out.push_back(profile.candela[c * profile.vertical.size()]);
    return out;
}

TEST(LightProfile, ReadsEveryVersionOfTheFormat) {
    for (const char* head :
         {"a luminaire of 1986\nsecond line\nTILT=NONE\n", "IESNA86\nTILT=NONE\n", "IESNA91\n[TEST]\nTILT=NONE\n",
          "IESNA:LM-63-1995\r\n[MORE] x\r\nTILT=NONE\r\n", "IESNA:LM-63-2002\nTILT=NONE  \n",
          "IES:LM-63-2019\nTILT= NONE\n", "TILT=INCLUDE\n1\n3\n0 45 90\n1 .9 .8\n"}) {
        const LightProfile profile = parse_profile(file({0}, head), "a.ies");
        EXPECT_THAT(profile.vertical, ElementsAre(0, 45, 90)) << head;
        EXPECT_THAT(profile.horizontal, ElementsAre(0)) << head;
        EXPECT_THAT(profile.candela, ElementsAre(1, 11, 21)) << "times multiplier 2 and ballast factor 0.5";
        EXPECT_EQ(profile.largest, 21);
    }
}

TEST(LightProfile, WritesOutWhatIsSymmetric) {
    const auto read = [](const std::vector<double>& horizontal) { return parse_profile(file(horizontal), "a.ies"); };
    LightProfile p = read({0, 45, 90});
    EXPECT_THAT(p.horizontal, ElementsAre(0, 45, 90, 135, 180, 225, 270, 315));
    EXPECT_THAT(first_row(p), ElementsAre(1, 101, 201, 101, 1, 101, 201, 101));
    p = read({0, 90, 180});
    EXPECT_THAT(p.horizontal, ElementsAre(0, 90, 180, 270));
    EXPECT_THAT(first_row(p), ElementsAre(1, 101, 201, 101));
    p = read({0, 120, 240, 360});
    EXPECT_THAT(p.horizontal, ElementsAre(0, 120, 240));
    EXPECT_THAT(first_row(p), ElementsAre(1, 101, 201));
    p = read({0, 100, 345});
    EXPECT_THAT(p.horizontal, ElementsAre(0, 100, 345));
    p = read({90, 135, 180, 270});
    EXPECT_THAT(p.horizontal, ElementsAre(0, 45, 90, 135, 180, 270));
    EXPECT_THAT(first_row(p), ElementsAre(201, 101, 1, 101, 201, 301));
}

TEST(LightProfile, TakesDosEndingsCommasAndPlusSigns) {
    std::string text = file({0});
    for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
        text.insert(at, "\r");
    text.replace(text.find("0 45 90"), 7, "+0,45, 9.0E1");
    EXPECT_THAT(parse_profile(text + "\r\n\x1a", "a.ies").vertical, ElementsAre(0, 45, 90));
}

TEST(LightProfile, WrongFilesAreOneLineWithTheNumberOfTheirs) {
    const std::string good = file({0, 45, 90});
    const auto error = [](const std::string& text) -> std::string {
        try {
            parse_profile(text, "a.ies");
        } catch (const Error& e) {
            EXPECT_THAT(e.what(), testing::Not(HasSubstr("\n")));
            return e.what();
        }
        return "";
    };
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return error(text.replace(at, from.size(), to));
    };
    EXPECT_EQ(error(good), "");
    EXPECT_EQ(error(""), "a.ies: line 0: there is no TILT= line: no LM-63 file");
    EXPECT_EQ(error("glTF\nno such thing\n"), "a.ies: line 2: there is no TILT= line: no LM-63 file");
    EXPECT_THAT(error(std::string("IESNA91\n\0\nTILT=NONE", 19)), HasSubstr("line 2: is not text"));
    EXPECT_EQ(changed("IESNA:LM-63-2002", "IESNA:LM-63-2099"),
              "a.ies: line 1: version \"IESNA:LM-63-2099\" is not read (1986, 1991, 1995, 2002 and 2019 are)");
    EXPECT_EQ(changed("TILT=NONE", "TILT=lamp.tlt"),
              "a.ies: line 3: TILT=lamp.tlt: factors in a file of their own are not read");
    EXPECT_EQ(changed("[TEST] a", "[BLOCK]"), "a.ies: line 2: [BLOCK]: several lamps in one file are not read");
    EXPECT_EQ(changed("1 -1 2 3 3 1", "1 -1 2 3 3 2"),
              "a.ies: line 4: photometric type 2 (B) is not read, only type C (1)");
    EXPECT_EQ(changed("1 -1 2 3 3 1", "1 -1 2 3 3 3"),
              "a.ies: line 4: photometric type 3 (A) is not read, only type C (1)");
    EXPECT_EQ(changed("1 -1 2 3 3 1", "1 -1 2 3 3 4"), "a.ies: line 4: photometric type: 4 is not one of 1 … 3");
    EXPECT_EQ(changed("1 -1 2 3 3 1", "1 -1 0 3 3 1"), "a.ies: line 4: candela multiplier: 0 is not above 0");
    EXPECT_EQ(changed("1 -1 2 3 3 1", "1 -1 2 1 3 1"),
              "a.ies: line 4: number of vertical angles: 1 is not one of 2 … 7201");
    EXPECT_EQ(changed("1 -1 2 3 3 1", "1 -1 2 3 0 1"),
              "a.ies: line 4: number of horizontal angles: 0 is not one of 1 … 7201");
    EXPECT_EQ(changed("1 -1 2 3 3 1", "1 -1 2 3.5 3 1"),
              "a.ies: line 4: number of vertical angles: 3.5 is not one of 2 … 7201");
    EXPECT_EQ(changed("1 -1 2 3 3 1", "1 -1 2 7000 7000 1"),
              "a.ies: line 4: 7000 × 7000 angles are more than are read (8388608 values)");
    EXPECT_EQ(changed("1 -1 2 3 3 1", "1 -1 two 3 3 1"), "a.ies: line 4: candela multiplier: \"two\" is no number");
    EXPECT_EQ(changed("1 -1 2 3 3 1", "1 -1 nan 3 3 1"), "a.ies: line 4: candela multiplier: \"nan\" is no number");
    EXPECT_EQ(changed("0 45 90", "0 45 45"), "a.ies: line 6: vertical angle: 45 after 45 does not ascend");
    EXPECT_EQ(changed("0 45 90", "0 45 190"), "a.ies: line 6: vertical angles 0 … 190 are not within 0 … 180");
    EXPECT_EQ(changed("0 45 90", "-90 0 90"), "a.ies: line 6: vertical angles -90 … 90 are not within 0 … 180");
    EXPECT_EQ(changed("45.000000 90.000000", "45 60"), "a.ies: line 7: horizontal angles 0 … 60: no symmetry is known "
                                                       "for that (0 alone, 0 … 90, 0 … 180, 0 … 360, 90 … 270)");
    EXPECT_THAT(changed("0.000000 45.000000 90.000000", "5 45 90"),
                HasSubstr("line 7: horizontal angles 5 … 90: no symmetry"));
    EXPECT_THAT(changed("0.000000 45.000000 90.000000", "0 45 400"),
                HasSubstr("line 7: horizontal angles 0 … 400: no symmetry"));
    EXPECT_EQ(changed("\n101", "\n-101"), "a.ies: line 11: candela -101 is negative");
    EXPECT_EQ(changed("\n101", "\n1e308"), "a.ies: line 11: candela 1e+308 times the file's factors is too large");
    EXPECT_EQ(changed("\n101", "\n1e999"), "a.ies: line 11: candela: \"1e999\" is no number");
    EXPECT_EQ(changed("\n101", "\n10\x01\x02"), "a.ies: line 11: candela: \"10??\" is no number");
    EXPECT_EQ(changed("\n221", ""), "a.ies: line 15: the file ends before candela");
    EXPECT_EQ(error(good + "7\n"),
              "a.ies: line 17: \"7\" comes after the last candela: there are more values than the angles ask for");
    EXPECT_EQ(error("TILT=INCLUDE\n4\n"), "a.ies: line 2: the lamp's place (1, 2 or 3): 4 is not one of 1 … 3");
    EXPECT_EQ(error("TILT=INCLUDE\n1 2 0 90 1 -1\n"), "a.ies: line 2: a tilt factor is negative");
    EXPECT_EQ(error("TILT=NONE\n1 1 1 2 1 1 1 0 0 0 1 1 0\n0 90\n0\n0 0\n"),
              "a.ies: line 5: all candela are 0: no light");
    EXPECT_THAT(error(std::string((16 << 20) + 1, ' ')), HasSubstr("more than an IES file may have"));
    EXPECT_THROW(load_profile("/nonexistent/a.ies"), Error);
}

// Whatever a file is cut or changed to, it ends in a profile that holds together, or in one line.
TEST(LightProfile, NoChangeOfAFileDoesHarm) {
    const std::string good = wall_lamp_profile();
    uint64_t state = 1;
    const auto random = [&](size_t below) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<size_t>(state >> 33) % below;
    };
    size_t read = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string text = good;
        for (size_t change = random(4); change > 0 && !text.empty(); --change)
            switch (random(4)) {
            case 0: text.resize(random(text.size()) + 1); break;
            case 1: text[random(text.size())] = static_cast<char>(random(256)); break;
            case 2: text.insert(random(text.size()), text, random(text.size()), random(80)); break;
            default: text.erase(random(text.size()), random(80)); break;
            }
        try {
            const LightProfile p = parse_profile(text, "a");
            ++read;
            ASSERT_EQ(p.candela.size(), p.vertical.size() * p.horizontal.size());
            ASSERT_GT(p.largest, 0);
            for (const double candela : p.candela)
                ASSERT_TRUE(candela >= 0 && candela <= p.largest);
            for (const double angle : p.horizontal)
                ASSERT_TRUE(angle >= 0 && angle < 360);
        } catch (const Error& error) {
            ASSERT_THAT(error.what(), testing::Not(HasSubstr("\n")));
        }
    }
    EXPECT_GT(read, 100u) << "some changes do nothing";
}

} // namespace
} // namespace prelight
