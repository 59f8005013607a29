#pragma once
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace prelight::gltf {

/// What is wrong with a URI or with the file it names, as one short reason.
struct UriError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

bool is_data_uri(std::string_view uri);
/// Length in bytes that `decode_data_uri` will give, at most.
uint64_t data_uri_size(std::string_view uri);
/// The bytes of a base64 data: URI. Throws UriError.
std::vector<uint8_t> decode_data_uri(std::string_view uri);
/// The regular file that a relative reference (RFC 3986, percent-encoded) names, canonical, proven
/// to lie in `folder` or below it with every symbolic link followed. Throws UriError.
std::filesystem::path resolve_uri(const std::filesystem::path& folder, std::string_view uri);

} // namespace prelight::gltf
