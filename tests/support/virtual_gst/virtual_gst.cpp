// Cameras from a text file, for programs that look for them through GStreamer. See README.md.
#include <gst/gst.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <poll.h>
#include <sstream>
#include <string>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace {

struct Line {
    std::string name, launch, caps;
};

std::filesystem::path filePath() {
    const char* const path = std::getenv("PMTS_VIRTUAL_GST");
    return path != nullptr ? path : "";
}

std::string fileText() {
    std::ifstream file(filePath());
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<Line> linesOf(const std::string& text) {
    std::vector<Line> lines;
    std::istringstream stream(text);
    for (std::string row; std::getline(stream, row);) {
        std::istringstream parts(row);
        Line line;
        if (std::getline(parts, line.name, '|') && std::getline(parts, line.launch, '|') && std::getline(parts, line.caps)) {
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

/// Elements that show a camera's picture: an unplugged camera ends their stream.
struct Showing {
    std::mutex mutex;
    std::vector<std::pair<std::string, GstElement*>> elements;

    static Showing& instance() {
        static auto* const showing = new Showing;  // programs show cameras until their very end
        return *showing;
    }
    void add(const std::string& name, GstElement* element) {
        const std::lock_guard lock(mutex);
        elements.emplace_back(name, GST_ELEMENT(gst_object_ref(element)));
    }
    void end(const std::string& name) {
        const std::lock_guard lock(mutex);
        std::erase_if(elements, [&name](const auto& shown) {
            if (shown.first != name) {
                return false;
            }
            gst_element_send_event(shown.second, gst_event_new_eos());
            gst_object_unref(shown.second);
            return true;
        });
    }
};

// A camera ----------------------------------------------------------------------------------------------------------

struct Camera {
    GstDevice parent;
    gchar* launch;
};
struct CameraClass {
    GstDeviceClass parent;
};
G_DEFINE_TYPE(Camera, camera, GST_TYPE_DEVICE)

GstElement* cameraElement(GstDevice* device, const gchar* name) {
    GError* error = nullptr;
    GstElement* const bin = gst_parse_bin_from_description(reinterpret_cast<Camera*>(device)->launch, TRUE, &error);
    g_clear_error(&error);
    if (bin != nullptr && name != nullptr) {
        gst_object_set_name(GST_OBJECT(bin), name);
    }
    if (bin != nullptr) {
        gchar* const camera_name = gst_device_get_display_name(device);
        Showing::instance().add(camera_name, bin);
        g_free(camera_name);
    }
    return bin;
}

void cameraFinalize(GObject* object) {
    g_free(reinterpret_cast<Camera*>(object)->launch);
    G_OBJECT_CLASS(camera_parent_class)->finalize(object);
}

void camera_class_init(CameraClass* type) {
    GST_DEVICE_CLASS(type)->create_element = cameraElement;
    G_OBJECT_CLASS(type)->finalize = cameraFinalize;
}

void camera_init(Camera*) {}

GstDevice* makeCamera(const Line& line) {
    GstCaps* const caps = gst_caps_from_string(line.caps.c_str());
    GstStructure* const properties =
        gst_structure_new("pmts-virtual", "device.path", G_TYPE_STRING, line.name.c_str(), nullptr);
    auto* const made = static_cast<Camera*>(g_object_new(camera_get_type(), "display-name", line.name.c_str(), "device-class",
                                                         "Video/Source", "caps", caps, "properties", properties, nullptr));
    made->launch = g_strdup(line.launch.c_str());
    gst_caps_unref(caps);
    gst_structure_free(properties);
    return GST_DEVICE(made);
}

// Those that are plugged in -----------------------------------------------------------------------------------------

/// Follows the file while somebody watches. Its folder is watched, since a file may be replaced by another one.
struct Watch {
    Watch() { inotify_add_watch(changes, filePath().parent_path().c_str(), IN_CLOSE_WRITE | IN_MOVED_TO | IN_DELETE); }
    ~Watch() {
        close(changes);
        close(stop);
    }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    /// Sleeps until something in the folder has changed; false when it is time to stop.
    bool nextChange() const {
        pollfd either[2] = {{changes, POLLIN, 0}, {stop, POLLIN, 0}};
        while (poll(either, 2, -1) < 0) {  // a signal woke it
        }
        alignas(inotify_event) char told[4096];
        return either[1].revents == 0 && read(changes, told, sizeof told) > 0;
    }
    void sayStop() const { eventfd_write(stop, 1); }

    const int changes = inotify_init1(IN_CLOEXEC);
    const int stop = eventfd(0, EFD_CLOEXEC);
    std::string text;
    std::vector<GstDevice*> plugged;
    std::thread thread;
};
struct Provider {
    GstDeviceProvider parent;
    Watch* watch;
};
struct ProviderClass {
    GstDeviceProviderClass parent;
};
G_DEFINE_TYPE(Provider, provider, GST_TYPE_DEVICE_PROVIDER)

void unplugAll(Watch& watch) {
    for (GstDevice* const device : watch.plugged) {
        gst_object_unref(device);
    }
    watch.plugged.clear();
}

void follow(GstDeviceProvider* provider, Watch& watch) {
    const std::string text = fileText();
    if (text == watch.text) {
        return;
    }
    watch.text = text;
    for (GstDevice* const device : watch.plugged) {
        gst_device_provider_device_remove(provider, device);
        gchar* const name = gst_device_get_display_name(device);
        Showing::instance().end(name);
        g_free(name);
    }
    unplugAll(watch);
    for (const Line& line : linesOf(text)) {
        GstDevice* const device = makeCamera(line);
        gst_object_ref_sink(device);
        watch.plugged.push_back(device);
        gst_device_provider_device_add(provider, device);
    }
}

GList* providerProbe(GstDeviceProvider*) {
    GList* found = nullptr;
    for (const Line& line : linesOf(fileText())) {
        found = g_list_append(found, makeCamera(line));
    }
    return found;
}

gboolean providerStart(GstDeviceProvider* base) {
    auto* const watch = new Watch;
    reinterpret_cast<Provider*>(base)->watch = watch;
    follow(base, *watch);
    watch->thread = std::thread([base, watch] {
        while (watch->nextChange()) {
            follow(base, *watch);
        }
    });
    return TRUE;
}

void providerStop(GstDeviceProvider* base) {
    Watch*& watch = reinterpret_cast<Provider*>(base)->watch;
    if (watch != nullptr) {
        watch->sayStop();
        watch->thread.join();
        unplugAll(*watch);
        delete watch;
        watch = nullptr;
    }
}

void provider_class_init(ProviderClass* type) {
    auto* const base = GST_DEVICE_PROVIDER_CLASS(type);
    base->probe = providerProbe;
    base->start = providerStart;
    base->stop = providerStop;
    gst_device_provider_class_set_static_metadata(base, "Virtual cameras", "Source/Video", "Cameras from a text file", "PMTS");
}

void provider_init(Provider* self) { self->watch = nullptr; }

gboolean pluginInit(GstPlugin* plugin) {
    return gst_device_provider_register(plugin, "pmtsvirtualprovider", GST_RANK_PRIMARY, provider_get_type());
}

}  // namespace

#define PACKAGE "pmts"
GST_PLUGIN_DEFINE(GST_VERSION_MAJOR, GST_VERSION_MINOR, pmtsvirtual, "Virtual cameras", pluginInit, "1", "GPL", PACKAGE,
                  "https://pmts.invalid/")
