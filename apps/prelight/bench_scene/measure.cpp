#include "measure.hpp"

#include "compare/times.hpp"
#include "interleave.hpp"
#include "progress.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight::app {
namespace {

constexpr double share_of_survey = 0.2; ///< of the progress bar
constexpr double share_to_survey = 0.4; ///< of a budget, at most, unless the first stop takes more
/// All figures are divided by F, and it is short.
constexpr uint32_t unit_repeats = 3;

/// The jobs on their way through the stops.
class Measurement {
public:
    Measurement(const std::vector<Job>& jobs, const std::vector<Stop>& stops, const SceneSeries& scenes,
                const BenchCommand& command, Device& device, bool pass_cpu, const TimeBudget& budget,
                const std::function<void(const Measured&)>& done)
        : jobs_(jobs), stops_(stops), command_(command), device_(device), pass_cpu_(pass_cpu), budget_(budget),
          done_(done), scene_(scenes.make()), camera_(camera_of(scene_->world, command.camera)),
          usable_(jobs.size(), true), stop_count_(stops.size()),
          seconds_(jobs.size(), std::vector<double>(stops.size(), 0)), slower_(pass_cpu ? 2 : 1) {
        out_.triangles = scene_->world.triangles;
        out_.camera = camera_.camera.name;
        for (const Stop& stop : stops)
            lights_.push_back(stop.count ? scenes.lights(*stop.count) : scene_->world.lights);
    }

    Measured run() {
        for (size_t j = 0; j < jobs_.size(); ++j)
            survey(j);
        std::vector<std::unique_ptr<Renderer>> renderers(jobs_.size());
        for (size_t j = 0; j < jobs_.size(); ++j)
            if (usable_[j]) {
                progress_.show(share_of_survey, "upload for " + jobs_[j].name());
                RenderOptions options = jobs_[j].options;
                options.pass_cpu = pass_cpu_;
                renderers[j] = create_renderer(jobs_[j].variant.renderer, &device_, options);
                renderers[j]->set_world(scene_->world);
            }
        for (size_t s = 0; s < stop_count_; ++s) {
            if (s > 0 && budget_.left() < 2 * round_seconds(s)) { // the warm-up, and a round
                stop_count_ = s;
                break;
            }
            time(s, renderers);
            progress_.clear();
            if (s + 1 < stop_count_) // the last is told with the whole
                done_(out_);
        }
        out_.left_out.assign(stops_.begin() + static_cast<std::ptrdiff_t>(stop_count_), stops_.end());
        return std::move(out_);
    }

private:
    std::span<const PlacedLight> lights_of(const Job& job, size_t stop) const {
        // The host's work for lights has no place in F either.
        if (job.role == Role::no_lights || job.role == Role::unit)
            return {};
        return lights_[stop];
    }

    std::string place(const Job& job, size_t stop) const {
        return fmt::format("{}: {}, {} light{}", command_.scene, job.name(), stops_[stop].lights,
                           stops_[stop].lights == 1 ? "" : "s");
    }

    /// One job by itself at each stop.
    void survey(size_t j) {
        const Job& job = jobs_[j];
        RenderOptions options = job.options;
        options.count_pairs = job.role != Role::unit && job.role != Role::no_lights;
        size_t stop = 0;
        try {
            const auto renderer = create_renderer(job.variant.renderer, &device_, options);
            renderer->set_world(scene_->world);
            for (; stop < stop_count_; ++stop) {
                if (stop > 0 && budget_.seconds() && budget_.spent() > share_to_survey * *budget_.seconds()) {
                    stop_count_ = stop;
                    break;
                }
                progress_.step(share_of_survey * double(j * stops_.size() + stop) /
                                   double(jobs_.size() * stops_.size()),
                               "pairs of " + place(job, stop));
                renderer->set_lights(lights_of(job, stop));
                renderer->render(camera_);
                renderer->stats(); // waits: lists that did not fit grow before the frame that counts
                const double before = budget_.spent();
                renderer->render(camera_);
                alone_.push_back({&job, stops_[stop], renderer->stats()});
                seconds_[j][stop] = budget_.spent() - before;
            }
        } catch (const Error& error) {
            fail(j, stop, error);
        }
    }

    void fail(size_t j, size_t stop, const Error& error) {
        const std::string line = fmt::format("{}: {}", place(jobs_[j], stop), error.what());
        if (jobs_[j].role == Role::contender && dynamic_cast<const UsageError*>(&error))
            throw UsageError(line);
        if (jobs_[j].role == Role::contender || jobs_[j].role == Role::unit)
            throw Error(line);
        usable_[j] = false;
        out_.missing.push_back(line);
    }

    /// All jobs at one stop, interleaved.
    void time(size_t s, std::vector<std::unique_ptr<Renderer>>& renderers) {
        const uint32_t frames = frames_at(s);
        const double began = budget_.spent();
        // The warm-up too is a round.
        const auto share = [&](double rounds) { return share_at(s, rounds, frames); };
        progress_.step(share(0),
                       fmt::format("frames with {} light{}", stops_[s].lights, stops_[s].lights == 1 ? "" : "s"));
        std::vector<Contender> contenders;
        std::vector<const Job*> owners;
        for (size_t j = 0; j < jobs_.size(); ++j) {
            if (!usable_[j])
                continue;
            show(s, share(double(contenders.size()) / double(jobs_.size())), "warm-up of " + jobs_[j].name());
            renderers[j]->set_lights(lights_of(jobs_[j], s));
            renderers[j]->render(camera_);
            renderers[j]->stats(); // waits, so that no other frame is drawn while one is timed
            contenders.push_back({.renderer = renderers[j].get(),
                                  .stats = {},
                                  .error = {},
                                  .repeats = jobs_[j].role == Role::unit ? unit_repeats : 1});
            owners.push_back(&jobs_[j]);
        }
        double turns = 0;
        uint32_t rounds = 1;
        const auto enough = [&] {
            const bool over = budget_.left() < round_seconds(s);
            rounds += over ? 0 : 1;
            return over;
        };
        render_interleaved(contenders, camera_, {.frames = frames, .enough = enough}, [&](const Contender& contender) {
            show(s, share(1 + turns++ / double(contenders.size())),
                 owners[static_cast<size_t>(&contender - contenders.data())]->name());
        });
        if (const double foreseen = (rounds + 1) * round_seconds(s); foreseen > 0)
            slower_ *= (budget_.spent() - began) / foreseen;
        out_.frames.emplace_back(stops_[s], rounds);
        for (size_t i = 0; i < contenders.size(); ++i) {
            if (!contenders[i].error.empty())
                throw Error(fmt::format("{}: {}", place(*owners[i], s), contenders[i].error));
            keep(owners[i], stops_[s], std::move(contenders[i].stats));
        }
    }

    void keep(const Job* job, const Stop& stop, Stats stats) {
        for (const Run& alone : alone_)
            if (alone.job == job && alone.stop.lights == stop.lights) {
                stats.device_bytes = alone.stats.device_bytes;
                stats.pairs_counted = alone.stats.pairs_counted;
                stats.pairs_evaluated = alone.stats.pairs_evaluated;
                stats.pairs_contributing = alone.stats.pairs_contributing;
            }
        out_.runs.push_back({job, stop, std::move(stats)});
    }

    /// One frame of each job in turn, as the survey lets expect.
    double round_seconds(size_t s) const {
        double sum = 0;
        for (size_t j = 0; j < jobs_.size(); ++j)
            if (usable_[j])
                sum += seconds_[j][s] * (jobs_[j].role == Role::unit ? unit_repeats : 1);
        return slower_ * sum;
    }

    /// As many as were asked for, or as fit: this stop and those after it share what is left.
    uint32_t frames_at(size_t s) const {
        const uint32_t wanted = command_.frames.value_or(1);
        double round = 0;
        for (size_t t = s; t < stop_count_; ++t)
            round += round_seconds(t);
        const double fit = budget_.left() / round - 1; // less the warm-up
        return fit >= wanted || !(round > 0) ? wanted : std::max(1u, static_cast<uint32_t>(std::max(fit, 0.0)));
    }

    /// By time: what is gone, over that and what is to be expected.
    double share_at(size_t s, double rounds, uint32_t frames) const {
        double left = std::max(frames + 1 - rounds, 0.0) * round_seconds(s);
        for (size_t t = s + 1; t < stop_count_; ++t)
            left += (frames + 1) * round_seconds(t);
        const double gone = std::max(budget_.spent(), 1e-3);
        return gone / (gone + left);
    }

    void show(size_t s, double share, const std::string& what) {
        progress_.show(share, fmt::format("{} lights: {}", stops_[s].lights, what));
    }

    const std::vector<Job>& jobs_;
    const std::vector<Stop>& stops_;
    const BenchCommand& command_;
    Device& device_;
    bool pass_cpu_;
    const TimeBudget& budget_;
    const std::function<void(const Measured&)>& done_;
    Progress progress_;
    std::unique_ptr<LoadedScene> scene_;
    PlacedCamera camera_;
    std::vector<bool> usable_;
    std::vector<std::vector<PlacedLight>> lights_; ///< by stop
    std::vector<Run> alone_;
    size_t stop_count_;                        ///< of stops_, from the first on, that there is time for
    std::vector<std::vector<double>> seconds_; ///< of a frame in the survey, by job and stop
    double slower_;                            ///< how much longer a frame takes when it is timed
    Measured out_;
};

} // namespace

const Run* Measured::find(const Job* job, const Stop& stop) const {
    const auto found =
        std::ranges::find_if(runs, [&](const Run& run) { return run.job == job && run.stop.lights == stop.lights; });
    return found == runs.end() ? nullptr : &*found;
}

Measured measure(const std::vector<Job>& jobs, const std::vector<Stop>& stops, const SceneSeries& scenes,
                 const BenchCommand& command, Device& device, bool pass_cpu, const TimeBudget& budget,
                 const std::function<void(const Measured&)>& done) {
    return Measurement(jobs, stops, scenes, command, device, pass_cpu, budget, done).run();
}

} // namespace prelight::app
