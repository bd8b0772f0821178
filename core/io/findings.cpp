#include "core/io/findings.h"

#include "core/io/text.h"

namespace mw {

Findings::Entry& Findings::entry(const Finding& finding)
{
    for (Entry& e : entries_)
        if (e.finding == &finding) return e;
    entries_.push_back({&finding, 0, {}, {}});
    return entries_.back();
}

std::vector<Warning> Findings::warnings() const
{
    std::vector<Warning> all;
    for (const Entry& e : entries_) {
        std::string text = std::to_string(e.count) + " " + (e.count == 1 ? e.finding->one : e.finding->many);
        for (size_t i = 0; i < e.places.size(); ++i) text += (i ? "; " : " (") + e.places[i];
        if (!e.places.empty()) text += e.count > e.places.size() ? "; ...)" : ")";
        all.push_back({e.finding->code, std::move(text), e.elements});
    }
    return all;
}

std::string inQuotes(std::string_view text)
{
    std::string q = "'";
    for (char c : text.substr(0, 40)) q += uint8_t(c) < ' ' || uint8_t(c) >= 0x7f ? '?' : c;
    return q + (text.size() > 40 ? "...'" : "'");
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && endsToken(text.front())) text.remove_prefix(1);
    while (!text.empty() && endsToken(text.back())) text.remove_suffix(1);
    return text;
}

}  // namespace mw
