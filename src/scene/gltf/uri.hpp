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
struct FoundFile {
    std::filesystem::path path; ///< canonical
    std::string warning;        ///< how it was found when not as the RFC has it; empty: as it has
};
/// The regular file that a relative reference (RFC 3986, percent-encoded) names, proven to lie in `folder` or below
/// it with every symbolic link followed. Where the URI is no valid percent code, or no file has the decoded name: the
/// one whose name is the URI as it is written, or with slashes for backslashes. Throws UriError, which names the file
/// as the URI does.
FoundFile resolve_uri(const std::filesystem::path& folder, std::string_view uri);

} // namespace prelight::gltf
