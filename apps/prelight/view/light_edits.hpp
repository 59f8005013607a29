#pragma once
#include <map>
#include <optional>
#include <prelight/scene.hpp>
#include <vector>

namespace prelight::app::viewer {

/// What has been done to the lights of a world. It is laid over them anew whenever time has moved them. A light's
/// number is its index in the world, and stays when others are removed; added ones follow.
class LightEdits {
public:
    struct Listed {
        uint32_t number = 0;
        PlacedLight placed;
    };
    /// All that shine, by number.
    std::vector<Listed> applied(const std::vector<PlacedLight>& base) const;
    /// The one of them with this number; absent: there is none.
    std::optional<PlacedLight> one(const std::vector<PlacedLight>& base, uint32_t number) const;
    /// Numbers there are, removed lights' too.
    uint32_t numbers(const std::vector<PlacedLight>& base) const {
        return static_cast<uint32_t>(base.size() + added_.size());
    }
    uint32_t removed() const;

    // False: there is no such light.
    bool move(const std::vector<PlacedLight>& base, uint32_t number, glm::dvec3 metres);
    bool colour(const std::vector<PlacedLight>& base, uint32_t number, glm::vec3 rgb);
    bool intensity(const std::vector<PlacedLight>& base, uint32_t number, float value);
    bool range(const std::vector<PlacedLight>& base, uint32_t number, float metres); ///< 0: infinite
    bool remove(const std::vector<PlacedLight>& base, uint32_t number);
    /// The new light's number.
    uint32_t add(const std::vector<PlacedLight>& base, const PlacedLight& light);
    /// Colours and intensities, from `seed`.
    void randomise(const std::vector<PlacedLight>& base, uint64_t seed);
    /// All turn by so many radians about the vertical axis through `centre`.
    void turn(double radians, glm::dvec3 centre);
    bool empty() const { return edits_.empty() && added_.empty() && turned_ == 0; }
    void clear() { *this = {}; }

private:
    struct Edit {
        glm::dvec3 moved{0};
        std::optional<glm::vec3> colour;
        std::optional<float> intensity, range;
        bool removed = false;
    };
    Edit* find(const std::vector<PlacedLight>& base, uint32_t number);

    std::map<uint32_t, Edit> edits_;
    std::vector<PlacedLight> added_;
    double turned_ = 0;
    glm::dvec3 centre_{0};
};

} // namespace prelight::app::viewer
