#include <scene/procedural/city_neon.hpp>

namespace prelight::city {
namespace {

/// Strokes on a grid of 5 × 9 points: two digits a point (column, row from below), a space between
/// strokes.
std::string_view strokes(char letter) {
    switch (letter) {
    case 'A': return "0006284640 0444";
    case 'B': return "00083847453404 3443413000";
    case 'C': return "4738180701103041";
    case 'D': return "00082846422000";
    case 'E': return "48080040 0434";
    case 'F': return "480800 0434";
    case 'G': return "47381807011030414424";
    case 'H': return "0008 4048 0444";
    case 'I': return "2028";
    case 'J': return "4841301001";
    case 'K': return "0008 480440";
    case 'L': return "080040";
    case 'M': return "0008244840";
    case 'N': return "00084048";
    case 'O': return "100107183847413010";
    case 'P': return "00083847453404";
    case 'R': return "00083847453404 2440";
    case 'S': return "473818070514344341301001";
    case 'T': return "0848 2028";
    case 'U': return "080110304148";
    case 'V': return "082048";
    case 'W': return "0810243048";
    case 'X': return "0048 0840";
    case 'Y': return "082448 2420";
    case 'Z': return "08480040";
    case '2': return "07183847450040";
    case '4': return "080444 4840";
    default: return "";
    }
}

} // namespace

void neon_letter(MeshBuilder& b, char letter, glm::vec3 corner, float height, float radius) {
    std::vector<glm::vec3> points;
    const auto flush = [&] {
        b.tube(points, radius, 6);
        points.clear();
    };
    const std::string_view code = strokes(letter);
    for (size_t i = 0; i + 1 < code.size();) {
        if (code[i] == ' ') {
            flush();
            ++i;
            continue;
        }
        const auto digit = [](char c) { return static_cast<float>(c - '0'); };
        points.push_back(corner + glm::vec3(digit(code[i]) / 8, digit(code[i + 1]) / 8, 0) * height);
        i += 2;
    }
    flush();
}

float neon_width(std::string_view text, float height) {
    return height * (0.72f * static_cast<float>(text.size()) - 0.22f);
}

void neon_row(MeshBuilder& b, std::string_view text, glm::vec3 corner, float height, float radius) {
    for (size_t i = 0; i < text.size(); ++i)
        neon_letter(b, text[i], corner + glm::vec3(0.72f * height * static_cast<float>(i), 0, 0), height, radius);
}

} // namespace prelight::city
