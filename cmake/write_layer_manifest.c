/* Prints a Vulkan layer manifest for the validation layer library given as argv[1].
 * The version and the instance extensions are what the library itself reports, so that the manifest
 * stays right when the package is updated. Run by ValidationLayer.cmake at configure time. */
#include <dlfcn.h>
#include <stdio.h>
#include <vulkan/vulkan.h>

#define LAYER "VK_LAYER_KHRONOS_validation"

int main(int argc, char** argv) {
    if (argc != 2)
        return 2;
    void* library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
    if (!library) {
        fprintf(stderr, "%s\n", dlerror());
        return 1;
    }
    PFN_vkEnumerateInstanceLayerProperties layers =
        (PFN_vkEnumerateInstanceLayerProperties)dlsym(library, "vkEnumerateInstanceLayerProperties");
    PFN_vkEnumerateInstanceExtensionProperties extensions =
        (PFN_vkEnumerateInstanceExtensionProperties)dlsym(library,
                                                          "vkEnumerateInstanceExtensionProperties");
    VkLayerProperties layer;
    VkExtensionProperties extension[32];
    uint32_t layer_count = 1, extension_count = 32;
    if (!layers || !extensions || layers(&layer_count, &layer) < 0 || layer_count != 1 ||
        extensions(LAYER, &extension_count, extension) < 0) {
        fprintf(stderr, "%s: not a validation layer\n", argv[1]);
        return 1;
    }
    const uint32_t v = layer.specVersion;
    printf("{\n  \"file_format_version\": \"1.2.0\",\n  \"layer\": {\n");
    printf("    \"name\": \"" LAYER "\",\n    \"type\": \"GLOBAL\",\n");
    printf("    \"library_path\": \"%s\",\n", argv[1]);
    printf("    \"api_version\": \"%u.%u.%u\",\n", VK_API_VERSION_MAJOR(v), VK_API_VERSION_MINOR(v),
           VK_API_VERSION_PATCH(v));
    printf("    \"implementation_version\": \"%u\",\n", layer.implementationVersion);
    printf("    \"description\": \"Khronos validation layer of the chromium package\",\n");
    printf("    \"instance_extensions\": [");
    for (uint32_t i = 0; i < extension_count; ++i)
        printf("%s\n      {\"name\": \"%s\", \"spec_version\": \"%u\"}", i ? "," : "",
               extension[i].extensionName, extension[i].specVersion);
    printf("\n    ]\n  }\n}\n");
    return 0;
}
