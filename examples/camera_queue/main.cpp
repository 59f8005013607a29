// A renderer in a thread of its own, without a window: the program queues cameras and goes on, pictures come when they
// are done. example_camera_queue [FOLDER [PICTURES]] writes FOLDER/camera-0.png …
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <future>
#include <prelight/device.hpp>
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>
#include <prelight/scene_io.hpp>
#include <thread>

namespace {

using namespace prelight;

/// Device and renderer are made, used and destroyed in one thread; only cameras and pictures go between threads.
class PictureThread {
public:
    /// `world` is not changed meanwhile.
    explicit PictureThread(const World& world) : thread_([this, &world] { work(world); }) {}
    ~PictureThread() { // after all that is queued
        {
            const std::scoped_lock lock(mutex_);
            ends_ = true;
        }
        changed_.notify_one();
        thread_.join();
    }
    PictureThread(const PictureThread&) = delete;
    PictureThread& operator=(const PictureThread&) = delete;

    std::future<Image> picture_of(const PlacedCamera& camera) {
        Job job{camera, {}};
        std::future<Image> picture = job.picture.get_future();
        {
            const std::scoped_lock lock(mutex_);
            jobs_.push_back(std::move(job));
        }
        changed_.notify_one();
        return picture;
    }

private:
    struct Job {
        PlacedCamera camera;
        std::promise<Image> picture;
    };

    std::optional<Job> next() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return ends_ || !jobs_.empty(); });
        if (jobs_.empty())
            return {};
        Job job = std::move(jobs_.front());
        jobs_.pop_front();
        return job;
    }

    void work(const World& world) {
        std::unique_ptr<Device> device;
        std::unique_ptr<Renderer> renderer;
        while (std::optional<Job> job = next()) {
            try {
                if (!renderer) {
                    device = Device::create({});
                    renderer = create_renderer("light-prepass", device.get(), {.width = 320, .height = 180});
                    renderer->set_world(world);
                }
                renderer->render(job->camera);
                job->picture.set_value(renderer->read("final"));
            } catch (...) {
                renderer.reset(); // the next job tries anew
                job->picture.set_exception(std::current_exception());
            }
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> jobs_;
    bool ends_ = false;
    std::thread thread_; ///< last: it uses the others
};

void run(const std::filesystem::path& folder, int count) {
    const Scene scene = make_scene("lights", 1000, 1);
    const World world = resolve(scene);
    PictureThread pictures(world);
    std::vector<std::future<Image>> coming;
    for (int i = 0; i < count; ++i) {
        PlacedCamera camera = world.cameras.at(0);
        camera.position += 0.4 * i * camera.axes[0]; // to the right
        coming.push_back(pictures.picture_of(camera));
    }
    for (int i = 0; i < count; ++i)
        save_png(coming[i].get(), folder / ("camera-" + std::to_string(i) + ".png"));
}

} // namespace

int main(int argc, char** argv) {
    try {
        run(argc > 1 ? argv[1] : ".", argc > 2 ? std::atoi(argv[2]) : 4);
        return 0;
    } catch (const prelight::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
