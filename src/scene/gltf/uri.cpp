#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <scene/gltf/json.hpp>
#include <scene/gltf/uri.hpp>

namespace prelight::gltf {
namespace {
namespace fs = std::filesystem;

bool is_alpha(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// RFC 3986 3.1: a letter, then letters, digits, '+', '-', '.', up to a colon.
bool has_scheme(std::string_view uri) {
    const size_t colon = uri.find(':');
    return colon != std::string_view::npos && colon > 0 && is_alpha(uri[0]) &&
           std::all_of(uri.begin(), uri.begin() + std::ptrdiff_t(colon),
                       [](char c) { return is_alpha(c) || is_digit(c) || c == '+' || c == '-' || c == '.'; });
}

int hex_digit(char c) {
    if (is_digit(c))
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// Nothing: it is no valid percent code.
std::optional<std::string> percent_decode(std::string_view uri) {
    std::string out;
    for (size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%') {
            if (i + 2 >= uri.size() || hex_digit(uri[i + 1]) < 0 || hex_digit(uri[i + 2]) < 0)
                return {};
            out += char(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2]));
            i += 2;
        } else {
            out += uri[i];
        }
    }
    return out;
}

/// Where the data of a data: URI begins. Throws UriError unless it is base64.
std::string_view data_of(std::string_view uri) {
    const size_t comma = uri.find(',');
    constexpr std::string_view marker = ";base64";
    if (comma == std::string_view::npos || comma < 5 + marker.size() ||
        uri.substr(comma - marker.size(), marker.size()) != marker)
        throw UriError("its data: URI is not base64");
    return uri.substr(comma + 1);
}

int base64_digit(char c) {
    if (c >= 'A' && c <= 'Z')
        return c - 'A';
    if (c >= 'a' && c <= 'z')
        return c - 'a' + 26;
    if (is_digit(c))
        return c - '0' + 52;
    if (c == '+' || c == '-')
        return 62;
    return c == '/' || c == '_' ? 63 : -1;
}

/// The regular file of that name in `folder` or below; nothing when there is none. `uri` is for messages.
std::optional<fs::path> find_within(const fs::path& folder, std::string_view name, std::string_view uri) {
    const auto outside = [&] {
        return UriError(fmt::format("its URI leads outside the scene's folder: \"{}\"", printable(uri)));
    };
    if (name.find('\0') != std::string_view::npos)
        throw UriError(fmt::format("its URI holds a zero byte: \"{}\"", printable(uri)));
    const fs::path relative(name);
    if (relative.is_absolute() || relative.has_root_path())
        throw outside();
    // By name first, so that nothing outside is even looked at; then with symbolic links followed.
    int depth = 0;
    for (const fs::path& part : relative) {
        depth += part == ".." ? -1 : part == "." || part.empty() ? 0 : 1;
        if (depth < 0)
            throw outside();
    }
    std::error_code error;
    const fs::path home = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
    if (error)
        throw UriError("the scene's folder cannot be read");
    const fs::path target = fs::canonical(home / relative, error);
    if (error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory)
        return {};
    if (error)
        throw UriError(fmt::format("\"{}\" cannot be read: {}", printable(uri), error.message()));
    const auto [home_end, target_at] = std::mismatch(home.begin(), home.end(), target.begin(), target.end());
    if (home_end != home.end() || target_at == target.end())
        throw outside();
    if (!fs::is_regular_file(target, error))
        throw UriError(fmt::format("its URI does not name a file: \"{}\"", printable(uri)));
    return target;
}

} // namespace

bool is_data_uri(std::string_view uri) { return uri.substr(0, 5) == "data:"; }

uint64_t data_uri_size(std::string_view uri) { return data_of(uri).size() / 4 * 3 + 3; }

std::vector<uint8_t> decode_data_uri(std::string_view uri) {
    std::string_view data = data_of(uri);
    while (!data.empty() && data.back() == '=')
        data.remove_suffix(1);
    if (data.size() % 4 == 1)
        throw UriError("its data: URI is cut short");
    std::vector<uint8_t> out;
    out.reserve(data.size() / 4 * 3 + 2);
    uint32_t bits = 0, count = 0;
    for (const char c : data) {
        const int digit = base64_digit(c);
        if (digit < 0)
            throw UriError("its data: URI holds a character that is not base64");
        bits = (bits << 6) | uint32_t(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            out.push_back(uint8_t(bits >> count));
        }
    }
    return out;
}

FoundFile resolve_uri(const fs::path& folder, std::string_view uri) {
    constexpr size_t longest = 4096;
    if (uri.empty())
        throw UriError("its URI is empty");
    if (uri.size() > longest)
        throw UriError("its URI is longer than 4096 characters");
    if (has_scheme(uri))
        throw UriError(fmt::format("its URI has a scheme; only data: and files beside the scene are read: \"{}\"",
                                   printable(uri)));
    const std::optional<std::string> decoded = percent_decode(uri);
    if (decoded)
        if (const auto found = find_within(folder, *decoded, uri))
            return {*found, {}};
    if (decoded != uri)
        if (const auto found = find_within(folder, uri, uri))
            return {*found, decoded ? "its URI names a file only as it is written, percent codes and all"
                                    : "its URI has a bad percent code; it is taken as it is written"};
    if (const std::string_view name = decoded ? std::string_view(*decoded) : uri;
        name.find('\\') != std::string_view::npos) {
        std::string slashes(name);
        std::ranges::replace(slashes, '\\', '/');
        if (const auto found = find_within(folder, slashes, uri))
            return {*found, "its URI has backslashes; they are taken for slashes"};
    }
    if (!decoded)
        throw UriError(
            fmt::format("its URI has a bad percent code, and no file has that name: \"{}\"", printable(uri)));
    throw UriError(fmt::format("\"{}\" cannot be read: No such file or directory", printable(uri)));
}

} // namespace prelight::gltf
