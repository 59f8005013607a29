// Wrong usage: exit status 2, one line, and nothing written.
#include "process.hpp"

#include <gmock/gmock.h>
#include <sstream>

namespace prelight::test {
namespace {

using testing::HasSubstr;

struct Wrong {
    const char* name;
    const char* arguments; ///< split at spaces
    const char* expected;  ///< a part of the message
};

void PrintTo(const Wrong& wrong, std::ostream* stream) { *stream << wrong.arguments; }

std::vector<std::string> split(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

class Usage : public testing::TestWithParam<Wrong> {};

TEST_P(Usage, IsRefusedInOneLine) {
    const TemporaryFolder folder;
    const Result result = run(split(GetParam().arguments), folder.path);
    EXPECT_TRUE(failed_with(result, 2));
    EXPECT_THAT(result.err, HasSubstr(GetParam().expected));
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(folder.entries(), 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, Usage,
    testing::Values(
        Wrong{"NoCommand", "", "--help"}, //
        Wrong{"UnknownCommand", "paint city -o a.png", "paint: not a command"},
        Wrong{"SequenceWithoutOutput", "sequence motion", "--output"},
        Wrong{"SequenceEnding", "sequence motion -o a.#.jpg", ".png, .exr, .mp4 or .mkv"},
        Wrong{"SequenceList", "sequence motion -o a.#.png --frames-at 5-1", "5-1 ends before it begins"},
        Wrong{"SequencePercent", "sequence motion -o a.%04d.png", "is written as #"},
        Wrong{"SequenceTwoRuns", "sequence motion -o a#.#.png", "more than one run of #"},
        Wrong{"SequenceFps", "sequence motion -o a.#.png --fps 0", "--fps 0"},
        Wrong{"SequenceTurntable", "sequence motion -o a.#.png --turntable 0", "--turntable 0"},
        Wrong{"SequenceShard", "sequence motion -o a.#.png --shard 0/4", "--shard 0/4"},
        Wrong{"SequenceTime", "sequence motion -o a.#.png --time 1", "--time"},
        Wrong{"SequenceWatch", "sequence motion -o a.#.png --watch", "--watch"},
        Wrong{"SequenceView", "sequence motion -o a.#.png --view nothing", "--view nothing"},
        Wrong{"SequenceVideoNumber", "sequence motion -o a.#.mp4", "a video is one file"},
        Wrong{"SequenceVideoShard", "sequence motion -o a.mkv --shard 1/2", "--shard: not with a.mkv"},
        Wrong{"SequenceVideoSkip", "sequence motion -o a.mp4 --skip-existing", "--skip-existing: not with a.mp4"},
        Wrong{"SequenceVideoOdd", "sequence motion -o a.mp4 --size 63x36", "even"},
        Wrong{"SequenceVideoLinear", "sequence motion -o a.mp4 --view linear", ".exr"},
        Wrong{"CompareWithoutFolder", "compare city", "--output"},
        Wrong{"CompareUnknownRenderer", "compare city -o out --renderers a", "a: not a renderer"},
        Wrong{"CompareEmptyRenderer", "compare city -o out --renderers multipass,", "--renderers"},
        Wrong{"CompareUnknownKey", "compare city -o out --renderers multipass@shape=round", "no setting shape"},
        Wrong{"CompareUnknownValue", "compare city -o out --renderers multipass@order=random", "lights, objects"},
        Wrong{"CompareUnknownPreset", "compare city -o out --renderers multipass@preset=x", "no preset x"},
        Wrong{"CompareSameTwice", "compare city -o out --renderers multipass,multipass", "named twice"},
        Wrong{"CompareNoCount", "compare city -o out --light-counts 1,,2", "--light-counts"},
        Wrong{"CompareCountTooLarge", "compare city -o out --light-counts 70000", "65536"},
        Wrong{"BenchUnknown", "bench town --json a.json", "town: neither a scene (city"},
        Wrong{"BenchNoCount", "bench lights --light-counts 1,,2 --json a.json", "--light-counts"},
        Wrong{"BenchEmptyCounts", "bench lights --light-counts , --json a.json", "--light-counts"},
        Wrong{"BenchZeroLights", "bench lights --light-counts 16,0 --json a.json", "--light-counts 16,0"},
        Wrong{"BenchTooManyLights", "bench lights --light-counts 65537 --json a.json", "65536"},
        Wrong{"BenchTwoCounts", "bench lights --light-counts 16 --lights 16 --json a.json", "--lights"},
        Wrong{"BenchRenderer", "bench lights --renderers a --json a.json", "a: not a renderer"},
        Wrong{"BenchUnit", "bench lights --renderers plain-forward --json a.json", "plain-forward: not a renderer"},
        Wrong{"BenchReference", "bench lights --renderers reference --json a.json", "reference: is not timed"},
        Wrong{"BenchSetting", "bench lights --set magic=1 --json a.json", "--set magic=1"},
        Wrong{"BenchSettingValue", "bench lights --set normals=magic --json a.json", "normals=magic"},
        Wrong{"BenchSceneFrames", "bench lights --frames 0", "--frames 0"},
        Wrong{"BenchSceneDevice", "bench lights --size 64x36 --device magic --json a.json", "magic"},
        Wrong{"BenchSceneCamera", "bench lights --size 64x36 --camera magic --json a.json", "magic"},
        Wrong{"BenchShading", "bench lights --shading toon", "ggx, phong"},
        Wrong{"BenchTableLimit", "bench encodings --limit", "--limit: goes with bench SCENE only"},
        Wrong{"BenchSceneOutput", "bench lights -o a.html", "-o: goes with bench report only"},
        Wrong{"BenchReportOfNothing", "bench report -o a.html", "no file"},
        Wrong{"BenchReportFormat", "bench report a.json -o a.png", ".html"},
        Wrong{"BenchReportWithoutPage", "bench report a.json", ".html"}, Wrong{"BenchOfNothing", "bench", "WHAT"},
        Wrong{"BenchSize", "bench encodings --size 64", "--size 64"},
        Wrong{"BenchFrames", "bench claims --frames 0", "--frames 0"},
        Wrong{"BenchCamera", "bench encodings --size 64x36 --camera magic --json a.json", "magic"},
        Wrong{"BenchDevice", "bench encodings --device magic --json a.json", "magic"},
        Wrong{"UnknownMaterial", "materials marble", "marble"}, Wrong{"NoScene", "render -o a.png", "SCENE"}, //
        Wrong{"NoOutput", "render city", "--output"}, Wrong{"TwoScenes", "render city spheres -o a.png", "spheres"},
        Wrong{"UnknownOption", "render city -o a.png --sharp", "--sharp"},
        Wrong{"MaterialWithoutFile", "render city -o a.png --material a", "--material"},
        Wrong{"TimeNegative", "render motion -o a.png --time=-1", "--time -1"},
        Wrong{"TimeGarbage", "render motion -o a.png --time noon", "--time noon"},
        Wrong{"TimeBeyond", "render motion -o a.png --time 1e7", "--time 1e7"},
        Wrong{"AnimationUnknown", "render motion -o a.png --size 64x36 --animation magic", "1 \"bend\""},
        Wrong{"AnimationBeyond", "render motion -o a.png --size 64x36 --animation 99", "--animation 99"},
        Wrong{"AnimationOfNone", "render spheres -o a.png --size 64x36 --animation 0", "there is none"},
        Wrong{"OptionTwice", "render city -o a.png --size 8x8 --size 9x9", "--size"},
        Wrong{"OptionWithoutValue", "render city -o a.png --size", "--size"},
        Wrong{"OutputWithoutExtension", "render city -o a", ".png or .exr"},
        Wrong{"OutputOtherFormat", "render city -o a.jpg", ".png or .exr"},
        Wrong{"ReferenceWithoutDevice", "render spheres -o a.png --renderer reference --validate", "--validate"},
        Wrong{"ReferenceCountsNoPairs", "render spheres -o a.png --renderer reference --count-pairs", "--count-pairs"},
        Wrong{"SizeNegative", "render city -o a.png --size=-64x36", "--size -64x36"},
        Wrong{"SizeOneNumber", "render city -o a.png --size 64", "--size 64"},
        Wrong{"SizeGarbage", "render city -o a.png --size axb", "--size axb"},
        Wrong{"SizeTrailing", "render city -o a.png --size 64x36x2", "--size 64x36x2"},
        Wrong{"SizeFraction", "render city -o a.png --size 64.5x36", "--size 64.5x36"},
        Wrong{"SizeOverflow", "render city -o a.png --size 18446744073709551680x36", "--size"},
        Wrong{"FramesZero", "render city -o a.png --frames 0", "--frames 0"},
        Wrong{"FramesGarbage", "render city -o a.png --frames many", "--frames many"},
        Wrong{"LightsZero", "render city -o a.png --lights 0", "--lights 0"},
        Wrong{"LightsNegative", "render city -o a.png --lights=-1", "--lights -1"},
        Wrong{"LightsBeyondBuiltin", "render city -o a.png --lights 65537", "65"},
        Wrong{"SeedGarbage", "render city -o a.png --seed x", "--seed x"},
        Wrong{"SeedOverflow", "render city -o a.png --seed 18446744073709551616", "--seed"},
        Wrong{"ExposureNaN", "render city -o a.png --exposure nan", "--exposure nan"},
        Wrong{"ExposureGarbage", "render city -o a.png --exposure 1e", "--exposure 1e"},
        Wrong{"ExposureBeyond", "render city -o a.png --exposure 1000", "--exposure 1000"},
        Wrong{"ExposureEmpty", "render city -o a.png --exposure automatic", "--exposure automatic"},
        Wrong{"ViewFromOneNumber", "render city -o a.png --view-from 30", "AZIMUTH,ELEVATION"},
        Wrong{"ViewFromGarbage", "render city -o a.png --view-from a,b", "--view-from a"},
        Wrong{"ViewFromThree", "render city -o a.png --view-from 1,2,3", "--view-from 2,3"},
        Wrong{"ViewFromBeyondThePole", "render city -o a.png --view-from 0,91", "-90 to 90"},
        Wrong{"ViewFromNaN", "render city -o a.png --view-from 0,nan", "--view-from nan"},
        Wrong{"ViewFromHalf", "render city -o a.png --view-from 10,", "--view-from"},
        Wrong{"ViewFromBesideACamera", "render city -o a.png --view-from 0,0 --camera 0", "--camera"},
        Wrong{"FitZero", "render city -o a.png --fit 0", "--fit 0"},
        Wrong{"FitNegative", "compare city -o out --fit=-1", "--fit -1"},
        Wrong{"FitGarbage", "render city -o a.png --fit tight", "--fit tight"},
        Wrong{"FitBesideACamera", "bench lights --fit 0.5 --camera 0", "--camera"},
        Wrong{"ViewFromOfATable", "bench encodings --view-from 0,0", "--view-from: goes with bench SCENE only"},
        Wrong{"EnvironmentUnknown", "render city -o a.png --environment meadow", "none, studio"},
        Wrong{"TonemapUnknown", "render city -o a.png --tonemap filmic", "pbr-neutral, aces, none"},
        Wrong{"ShadingUnknown", "render city -o a.png --shading toon", "ggx, phong"},
        Wrong{"MsaaSix", "render city -o a.png --size 64x36 --msaa 6", "--msaa 6: not one of 1, 2, 4"},
        Wrong{"MsaaThree", "render city -o a.png --size 64x36 --renderer reference --msaa 3",
              "--msaa 3: not one of 1, 2, 4"},
        Wrong{"MsaaEight", "render city -o a.png --size 64x36 --renderer reference --msaa 8", "one of 1, 2, 4"},
        Wrong{"MsaaSixteen", "render city -o a.png --size 64x36 --renderer reference --msaa 16", "one of 1, 2, 4"},
        Wrong{"MsaaLightOfOneSample", "render spheres -o a.png --renderer reference --set msaa-light=pixel",
              "--set msaa-light=pixel: needs --msaa 2 or 4, and it is 1"},
        Wrong{"MsaaShadowsWithoutShadows",
              "render spheres -o a.png --renderer reference --msaa 4 --set msaa-shadows=pixel", "needs shadows=on"},
        Wrong{"MsaaShadowsOfOneLight",
              "render spheres -o a.png --msaa 4 --set shadows=on --set msaa-light=pixel --set msaa-shadows=pixel",
              "--set msaa-shadows=pixel: needs msaa-light=edges or samples, and it is pixel"},
        Wrong{"MsaaShadowsOfForwardRenderers", "render spheres -o a.png --renderer z-prepass --set msaa-shadows=pixel",
              "msaa-shadows"},
        Wrong{"SampleOfOne", "render spheres -o a.png --msaa 1 --view sample=0",
              "--view sample=0: needs --msaa 2 or 4, and it is 1"},
        Wrong{"SampleOfHalfSamples", "render glass -o a.png --msaa 4 --set transparency=half-samples --view sample=0",
              "--view sample=0: with transparency=half-samples"},
        Wrong{"SampleBeyond", "render spheres -o a.png --msaa 4 --view sample=4", "sample=0 … sample=3"},
        Wrong{"MsaaZero", "render city -o a.png --msaa 0", "--msaa 0"},
        Wrong{"RendererUnknown", "render city -o a.png --renderer magic", "light-prepass"},
        Wrong{"PresetUnknown", "render city -o a.png --preset magic", "magic"},
        Wrong{"SetOfTheOtherModel", "render spheres -o a.png --set specular-gate=step",
              "--set specular-gate=step: needs --shading phong, and it is ggx"},
        Wrong{"SetThatNeedsAnother", "render spheres -o a.png --set light-culling=volumes --set tile-size=16",
              "--set tile-size=16: needs light-culling=tiles or clusters, and it is volumes"},
        Wrong{"SetOfShadows", "render spheres -o a.png --renderer multipass --set shadow-filter=hard",
              "needs shadows=on"},
        Wrong{"SetOfTheReference", "render spheres -o a.png --renderer reference --shading phong --set model=nv",
              "needs --shading ggx"},
        Wrong{"SetInAPresetsModel", "render spheres -o a.png --preset round2 --set model=nv",
              "needs --shading ggx, and it is phong"},
        Wrong{"BenchSetWithoutEffect",
              "bench lights --size 64x36 --light-counts 4 --renderers light-prepass@preset=prelighting@tile-size=16 "
              "--json a.json",
              "needs light-culling=tiles or clusters, and it is rectangles"},
        Wrong{"CompareSetWithoutEffect",
              "compare lights --size 32x18 --light-counts none --renderers light-prepass@ssao-radius=2 -o out",
              "needs ssao=half or full or --view ambient-occlusion"},
        Wrong{"SetWithoutValue", "render city -o a.png --set normals", "KEY=VALUE"},
        Wrong{"SetUnknownKey", "render city -o a.png --set magic=1", "magic"},
        Wrong{"SetUnknownValue", "render city -o a.png --set normals=magic", "magic"},
        Wrong{"SetReference", "render city -o a.png --renderer reference --set magic=1", "magic"},
        Wrong{"ViewUnknown", "render city -o a.png --view magic", "diffuse-light"},
        Wrong{"ViewAsExr", "render city -o a.exr --view depth", "EXR"},
        Wrong{"LinearAsPng", "render city -o a.png --view linear", ".exr"},
        Wrong{"TwoViewsOneFile", "render city -o a.png --view depth --view normal", "BUFFER=FILE"},
        Wrong{"ViewFileFormat", "render city -o a.png --view depth=a.exr", ".png"},
        Wrong{"SameFileTwice", "render city -o a.png --view depth=./a.png", "two outputs"},
        Wrong{"DeviceUnknown", "render city -o a.png --device magic", "magic"},
        Wrong{"DeviceIndexBeyond", "render city -o a.png --device 99", "99"},
        Wrong{"CameraUnknown", "render spheres -o a.png --size 64x36 --camera magic", "magic"},
        Wrong{"CameraBeyond", "render spheres -o a.png --size 64x36 --camera 99", "99"},
        Wrong{"WatchBuiltin", "render city -o a.png --watch", "--watch"},
        Wrong{"MakeUnknown", "make magic -o a.glb", "city"}, Wrong{"MakeNoOutput", "make city", "--output"},
        Wrong{"MakeFormat", "make city -o a.gltf", ".glb"},
        Wrong{"MakeLightsBeyond", "make city -o a.glb --lights 65537", "65"},
        Wrong{"RenderersUnknown", "renderers magic", "light-prepass"}, Wrong{"DevicesArgument", "devices now", "now"}),
    [](const auto& kind) { return std::string(kind.param.name); });

} // namespace
} // namespace prelight::test
