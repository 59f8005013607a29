#include "output.hpp"

#include <image/atomic_file.hpp>

namespace prelight::app {

void check_writable(const std::filesystem::path& path) {
    const WriteGuard guard;
    const AtomicFile probe(path); // never committed, so it goes again
}

void save_text(std::string_view text, const std::filesystem::path& path) {
    const WriteGuard guard;
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

} // namespace prelight::app
