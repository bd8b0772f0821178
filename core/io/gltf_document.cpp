#include "core/io/gltf_document.h"

#include <algorithm>
#include <cstring>

namespace mw {

namespace {

constexpr const char* damaged = "; the file is cut or damaged";

std::string amount(double bytes)
{
    const char* unit[] = {"bytes", "kB", "MB", "GB", "TB", "PB"};
    int u = 0;
    for (; bytes >= 10000 && u < 5; ++u) bytes /= 1000;
    return std::to_string(uint64_t(bytes + 0.5)) + " " + unit[u];
}

GltfComponent componentOf(const JsonPlace& place)
{
    const uint64_t c = place.whole();
    if (c < 5120 || c > 5126 || c == 5124) place.fail("component type " + std::to_string(c) + " does not exist" + damaged);
    return GltfComponent(c);
}

// Components of a type, and its bytes: columns of matrices start at multiples of 4.
void setType(GltfAccessor& a, const JsonPlace& place)
{
    struct Type {
        const char* name;
        int columns, rows;
    };
    constexpr Type types[] = {{"SCALAR", 1, 1}, {"VEC2", 1, 2}, {"VEC3", 1, 3}, {"VEC4", 1, 4}, {"MAT2", 2, 2}, {"MAT3", 3, 3}, {"MAT4", 4, 4}};
    const std::string& name = place.text();
    for (const Type& t : types) {
        if (name != t.name) continue;
        a.components = t.columns * t.rows;
        size_t column = size_t(t.rows) * sizeOf(a.component);
        if (t.columns > 1) column = (column + 3) & ~size_t(3);
        a.elementSize = column * size_t(t.columns);
        return;
    }
    place.fail("there is no type \"" + name.substr(0, 20) + "\"" + damaged);
}

// `count` elements of `size` bytes every `stride` bytes from `offset` fit into `available`; all in doubles against overflow.
void checkExtent(const JsonPlace& place, double count, double size, double stride, double offset, size_t available)
{
    if (count == 0) return;
    const double needed = offset + stride * (count - 1) + size;
    if (needed > double(available))
        place.fail("count " + std::to_string(uint64_t(count)) + " needs " + amount(needed) + " of " + amount(double(available)) + damaged);
}

template <class T>
T valueAt(const uint8_t* p)
{
    T v;
    std::memcpy(&v, p, sizeof v);
    return v;
}

// Calls `f` with a null pointer of the C++ type of `c`.
template <class F>
void withType(GltfComponent c, F f)
{
    switch (c) {
        case GltfComponent::Int8:
            return f(static_cast<int8_t*>(nullptr));
        case GltfComponent::UInt8:
            return f(static_cast<uint8_t*>(nullptr));
        case GltfComponent::Int16:
            return f(static_cast<int16_t*>(nullptr));
        case GltfComponent::UInt16:
            return f(static_cast<uint16_t*>(nullptr));
        case GltfComponent::UInt32:
            return f(static_cast<uint32_t*>(nullptr));
        case GltfComponent::Float32:
            return f(static_cast<float*>(nullptr));
    }
}

template <class Out, class T>
Out converted(T v, bool normalized)
{
    if constexpr (std::is_same_v<Out, float> && std::is_integral_v<T>) {
        if (normalized) return std::max(float(double(v) / double(std::numeric_limits<T>::max())), -1.f);
    } else if constexpr (std::is_integral_v<Out> && std::is_floating_point_v<T>) {
        return v > T(-2e9) && v < T(2e9) ? Out(v) : Out(0);
    }
    return Out(v);
}

}  // namespace

size_t sizeOf(GltfComponent c)
{
    return c == GltfComponent::UInt32 || c == GltfComponent::Float32 ? 4 : c == GltfComponent::Int16 || c == GltfComponent::UInt16 ? 2 : 1;
}

GltfDocument::GltfDocument(std::span<const uint8_t> content, std::filesystem::path folder)
    : container_(gltfContainer(content)), folder_(std::move(folder)), inputBytes_(content.size())
{
    charge(container_.jsonCost, "/");
    const JsonPlace top = root();
    const std::string& version = top["asset"]["version"].text();
    if (!version.starts_with("2."))
        top["asset"]["version"].fail("version \"" + version.substr(0, 20) + "\"; only 2.0 can be read, export it again as glTF 2.0");
    readBuffers();
    for (size_t i = 0; i < top.sizeOf("bufferViews"); ++i) views_.push_back(viewOf(top["bufferViews"][i]));
    const size_t accessors = top.sizeOf("accessors");
    charge(accessors * sizeof(GltfAccessor), "/accessors");
    for (size_t i = 0; i < accessors; ++i) accessors_.push_back(accessorOf(top["accessors"][i]));
}

void GltfDocument::charge(uint64_t bytes, const std::string& pointer)
{
    charged_ += bytes;
    if (charged_ > gltfBudget(inputBytes_))
        throw Error(pointer + ": reading on would take " + amount(double(charged_)) + " for a file of " + amount(double(inputBytes_)) +
                    ", because the same data is used again and again or is not there at all; the file is damaged");
}

void GltfDocument::readBuffers()
{
    const JsonPlace top = root();
    for (size_t i = 0; i < top.sizeOf("buffers"); ++i) buffers_.push_back(bufferOf(top["buffers"][i], i));
}

std::span<const uint8_t> GltfDocument::bufferOf(const JsonPlace& place, size_t index)
{
    const uint64_t length = place["byteLength"].whole();
    std::span<const uint8_t> bytes;
    if (const auto uri = place.find("uri")) {
        owned_.push_back(resource(*uri));
        bytes = *owned_.back();
    } else if (index == 0 && container_.hasBin) {
        bytes = container_.bin;
    } else {
        place.fail("has no data; the file is damaged, or compressed in a way that is not supported: export it without compression");
    }
    if (length > bytes.size())
        place.fail("byteLength is " + std::to_string(length) + ", but there are only " + std::to_string(bytes.size()) + " bytes" + damaged);
    return bytes.subspan(0, length);
}

GltfView GltfDocument::viewOf(const JsonPlace& place) const
{
    GltfView v;
    v.buffer = place["buffer"].index(buffers_.size(), "buffer");
    v.offset = place.whole("byteOffset", 0);
    v.length = place["byteLength"].whole();
    v.stride = place.whole("byteStride", 0);
    const size_t available = buffers_[v.buffer].size();
    if (v.offset > available || v.length > available - v.offset)
        place.fail("bytes " + std::to_string(v.offset) + " to " + std::to_string(v.offset + v.length) + " of a buffer of " +
                   std::to_string(available) + damaged);
    if (v.stride > 252) place.fail("byteStride " + std::to_string(v.stride) + " is more than 252" + damaged);
    return v;
}

GltfAccessor GltfDocument::accessorOf(const JsonPlace& place)
{
    GltfAccessor a;
    a.pointer = place.pointer();
    a.component = componentOf(place["componentType"]);
    setType(a, place["type"]);
    a.count = place["count"].whole();
    a.normalized = place.flag("normalized", false);
    a.view = place.index("bufferView", views_.size(), "buffer view");
    a.offset = place.whole("byteOffset", 0);
    for (const char* bound : {"min", "max"})
        if (const auto b = place.find(bound)) {
            if (b->size() != size_t(a.components)) b->fail("must have " + std::to_string(a.components) + " numbers");
            for (size_t i = 0; i < b->size(); ++i) (*b)[i].number();
        }
    if (a.count > 0xFFFFFFFEu && !a.view) place.fail("count " + std::to_string(a.count) + " is more than 32 bits can number" + damaged);
    if (a.view) {
        const size_t step = stride(a);
        if (step < a.elementSize) place.fail("elements of " + std::to_string(a.elementSize) + " bytes every " + std::to_string(step) + damaged);
        checkExtent(place, double(a.count), double(a.elementSize), double(step), double(a.offset), views_[*a.view].length);
        if ((views_[*a.view].offset + a.offset) % sizeOf(a.component) || step % sizeOf(a.component))
            warnings().push_back(
                {"misaligned", a.pointer + ": not aligned to its component size, which other programs may refuse; read all the same", {}});
    }
    if (const auto s = place.find("sparse")) checkSparse(a, *s);
    return a;
}

void GltfDocument::checkSparse(GltfAccessor& a, const JsonPlace& place) const
{
    GltfAccessor::Sparse s;
    s.count = place["count"].whole();
    const JsonPlace indices = place["indices"], values = place["values"];
    s.indexView = indices["bufferView"].index(views_.size(), "buffer view");
    s.valueView = values["bufferView"].index(views_.size(), "buffer view");
    s.indexOffset = indices.whole("byteOffset", 0);
    s.valueOffset = values.whole("byteOffset", 0);
    s.indexComponent = componentOf(indices["componentType"]);
    const double indexSize = double(sizeOf(s.indexComponent)), size = double(a.elementSize);
    checkExtent(indices, double(s.count), indexSize, indexSize, double(s.indexOffset), views_[s.indexView].length);
    checkExtent(values, double(s.count), size, size, double(s.valueOffset), views_[s.valueView].length);
    if (s.count == 0) return;
    const uint8_t* p = viewBytes(s.indexView).data() + s.indexOffset;
    double last = -1;
    withType(s.indexComponent, [&]<class T>(T*) {
        for (size_t i = 0; i < s.count; ++i) {
            const double at = double(valueAt<T>(p + i * sizeof(T)));
            if (!(at > last) || at >= double(a.count))
                indices.fail("entry " + std::to_string(i) + " is not ascending or not below the count" + damaged);
            last = at;
        }
    });
    a.sparse = s;
}

size_t GltfDocument::stride(const GltfAccessor& a) const
{
    return views_[*a.view].stride ? views_[*a.view].stride : a.elementSize;
}

std::span<const uint8_t> GltfDocument::viewBytes(size_t view) const
{
    const GltfView& v = views_[view];
    return buffers_[v.buffer].subspan(v.offset, v.length);
}

template <class Out>
Array<Out> GltfDocument::decoded(const GltfAccessor& a, std::span<const uint32_t> elements)
{
    const size_t n = size_t(a.components);
    charge(elements.size() * n * sizeof(Out), a.pointer);
    Array<Out> out(elements.size() * n, Out(0));
    if (elements.empty()) return out;
    withType(a.component, [&]<class T>(T*) {
        const auto take = [&](const uint8_t* from, Out* to) {
            for (size_t c = 0; c < n; ++c) to[c] = converted<Out>(valueAt<T>(from + c * sizeof(T)), a.normalized);
        };
        if (a.view) {
            const uint8_t* base = viewBytes(*a.view).data() + a.offset;
            const size_t step = stride(a);
            for (size_t i = 0; i < elements.size(); ++i) take(base + elements[i] * step, out.data() + i * n);
        }
        if (!a.sparse) return;
        const uint8_t* values = viewBytes(a.sparse->valueView).data() + a.sparse->valueOffset;
        const uint8_t* indices = viewBytes(a.sparse->indexView).data() + a.sparse->indexOffset;
        withType(a.sparse->indexComponent, [&]<class I>(I*) {
            for (size_t i = 0; i < a.sparse->count; ++i) {
                const auto at = std::lower_bound(elements.begin(), elements.end(), uint32_t(valueAt<I>(indices + i * sizeof(I))));
                if (at != elements.end() && *at == uint32_t(valueAt<I>(indices + i * sizeof(I))))
                    take(values + i * a.elementSize, out.data() + size_t(at - elements.begin()) * n);
            }
        });
    });
    return out;
}

Array<float> GltfDocument::floats(const GltfAccessor& a, std::span<const uint32_t> elements)
{
    return decoded<float>(a, elements);
}

Array<int32_t> GltfDocument::integers(const GltfAccessor& a, std::span<const uint32_t> elements)
{
    return decoded<int32_t>(a, elements);
}

Array<uint32_t> GltfDocument::indices(const GltfAccessor& a)
{
    if (a.components != 1 || a.component == GltfComponent::Float32)
        throw Error(a.pointer + ": indices must be whole numbers of type SCALAR" + damaged);
    charge(a.count * 4, a.pointer);
    Array<uint32_t> all(a.count, 0u);
    for (size_t i = 0; i < a.count; ++i) all[i] = uint32_t(i);
    return decoded<uint32_t>(a, all);
}

}  // namespace mw
