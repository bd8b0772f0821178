// What a reader finds odd and goes on from: each kind becomes one warning with its number, its first places and the elements.
#pragma once
#include <string>
#include <vector>

#include "core/error.h"
#include "core/mesh/mesh.h"

namespace mw {

/// "face uses a vertex that is not there: left out", "faces use ...". The number is put before it.
struct Finding {
    const char *code, *one, *many;
};

class Findings {
public:
    /// `place` gives the text of the place ("line 12: vertex 99 of 4"); it is called for the first few only. `finding` must live on.
    template <class Place>
    void add(const Finding& finding, Place&& place, uint32_t element = none)
    {
        Entry& e = entry(finding);
        ++e.count;
        if (e.places.size() < 3) e.places.push_back(place());
        if (element != none && e.elements.size() < 1000) e.elements.push_back(element);
    }
    void add(const Finding& finding) { ++entry(finding).count; }
    bool empty() const { return entries_.empty(); }
    std::vector<Warning> warnings() const;

private:
    struct Entry {
        const Finding* finding;
        size_t count = 0;
        std::vector<std::string> places;
        std::vector<uint32_t> elements;
    };
    Entry& entry(const Finding& finding);
    std::vector<Entry> entries_;
};

}  // namespace mw
