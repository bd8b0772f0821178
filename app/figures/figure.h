// The book's figures, made again: each is an id, the rows of the mission it proves, and a function that puts panels on a page.
//
// How to add one: write `void myFigure(Page& page)` in the file of its chapter, and one line in that file's list:
//     {"3.13-splits", "3.13", "Dyadic splits", {"3.6"}, splits},
// In the function
//     Space& a = page.space("before");          // a view in space: meshes by put(), marks, and lines, arrows, labels by place
//     a.put(mesh); a.faces({3, 7}, page.ink(Ink::Focus)); a.numberVertices(page.ink(Ink::Text), page.ink(Ink::Faint));
//     Drawing& d = page.drawing("its plane");   // a view of the plane, y up, fitted to what is drawn
//     d.arrow({0, 0}, {1, 2}, page.ink(Ink::New)); d.label({1, 2}, "P1");
//     TablePanel& t = page.table("records", {"vertex", "x"}); t.row({"0", "1.5"});
//     Plot& p = page.plot("error", "iteration", "residual"); p.series("Jacobi", xs, ys, page.series(0));
//     page.row();                               // the panels that follow stand below
//     page.number("faces", mesh.faceCount());   // goes into gallery.json; tests/cli/figure_numbers_CHAPTER.py says what it must be
// Every number in a picture is computed there and then. Panels are lettered (a), (b), ... by themselves.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "app/figures/painter.h"
#include "render/offscreen.h"

namespace mw::figures {

/// What a colour means, in either theme.
enum class Ink { Text, Faint, Line, Paper, Panel, Focus, Neighbour, Removed, New, Offender, Rejected };

/// A place: of the plane or in space.
struct At {
    glm::dvec3 p{0};
    At() = default;
    At(double x, double y, double z = 0) : p(x, y, z) {}
    At(glm::dvec2 v) : p(v, 0) {}
    At(glm::dvec3 v) : p(v) {}
    At(glm::vec3 v) : p(v) {}
};

/// Part of a page: a picture with a caption, perhaps with a legend between them.
class Panel {
public:
    virtual ~Panel() = default;
    std::string caption, letter;
    glm::vec2 extent{430, 380};  ///< of the picture, logical pixels
    bool framed = true;          ///< on a ground of its own colour
    struct Key {
        glm::vec4 color;
        std::string text;
        bool line = false;
    };
    std::vector<Key> keys;  ///< swatches below the picture
    struct Scale {
        HeatMap heat;
        bool histogram = false;
        std::string title;
    };
    std::optional<Scale> scale;  ///< a colour bar below the picture

    Panel& key(glm::vec4 color, std::string text)
    {
        keys.push_back({color, std::move(text), false});
        return *this;
    }
    Panel& lineKey(glm::vec4 color, std::string text)
    {
        keys.push_back({color, std::move(text), true});
        return *this;
    }
    /// For panels whose size is that of their text.
    virtual void measure(Painter&) {}
    /// Once the place on the page is known.
    virtual void arrange(const Box& place) { place_ = place; }
    virtual void paint(Painter& painter) = 0;
    /// Views in space draw their picture here, before everything is painted over it.
    virtual std::optional<Picture> picture(Offscreen&, float /*pixelRatio*/) { return {}; }
    /// Where on the page a place of this panel is.
    virtual glm::vec2 onPage(const At&) const { return place_.middle(); }
    const Box& place() const { return place_; }

protected:
    Box place_;
};

/// Lines, shapes and text by place, in the order: shapes, then discs and text over them.
class Layer : public Panel {
public:
    void line(At a, At b, const Pen& pen);
    void path(std::vector<At> points, const Pen& pen, bool closed = false);
    void arrow(At a, At b, const Pen& pen) { line(a, b, pen.arrow()); }
    void arrow(At a, At b, glm::vec4 color, float width = 2) { line(a, b, Pen(color, width).arrow()); }
    void polygon(std::vector<At> corners, glm::vec4 fill);
    void disc(At at, glm::vec4 fill, float diameter = 9);
    void ring(At at, glm::vec4 color, float diameter = 12, float width = 2);  ///< a disc that is not filled
    void label(At at, std::string text, glm::vec4 color, Beside beside = Beside::Auto, int size = 15, bool bold = false);
    void words(At at, std::string text, const Words& look);

protected:
    void paintItems(Painter& painter) const;
    struct Item {
        enum class Kind { Path, Polygon, Disc, Words } kind;
        std::vector<At> at;
        Pen pen = {};
        glm::vec4 fill{0};
        float diameter = 0;
        std::string text = {};
        Words look = {};
    };
    std::vector<Item> items_;
    glm::vec4 paper_{1};
    friend class Page;
};

/// A view of the plane, y up. What is drawn fills the panel, or the window given.
class Drawing : public Layer {
public:
    float margin = 34;  ///< pixels round what is drawn: room for labels
    void window(glm::dvec2 low, glm::dvec2 high) { low_ = low, high_ = high, given_ = true; }
    /// An arc about a point, angles in radians from +x.
    void arc(At centre, double radius, double from, double to, const Pen& pen);

    void arrange(const Box& place) override;
    void paint(Painter& painter) override;
    glm::vec2 onPage(const At& at) const override;

private:
    glm::dvec2 low_{0}, high_{1};
    bool given_ = false;
    double unit_ = 1;
};

/// A view in space: a frame as the window draws it, and a layer over it. The camera is moved to where everything fits, `zoom` times closer.
class Space : public Layer {
public:
    Frame frame;
    double zoom = 0.92;

    /// Degrees, as setView(); parallel unless asked.
    void look(double azimuth, double elevation, bool perspective = false);
    void fixed(const Camera& camera);  ///< this camera and no other
    NodeId put(Mesh mesh, const glm::dmat4& worldFromLocal = glm::dmat4(1));
    DrawObject& object(NodeId node);
    const Mesh& mesh(NodeId node) { return object(node).mesh; }
    // Marks on an object, the last one put unless said.
    void faces(std::vector<uint32_t> faces, glm::vec4 color, NodeId node = {});
    void edges(std::vector<uint32_t> vertexPairs, glm::vec4 color, float width = 4, NodeId node = {}, bool dashed = false, bool through = false);
    void vertices(std::vector<uint32_t> vertices, glm::vec4 color, float diameter = 10, NodeId node = {});
    /// Numbers at all vertices; in `behind` where something lies before them.
    void numberVertices(glm::vec4 color, glm::vec4 behind, NodeId node = {}, int size = 15);
    bool hidden(const At& at) const;  ///< by a face of what was put, seen from the camera as it is turned now
    /// Values as colours, with a scale below the picture. low > high: the range that shows most.
    void heat(Table table, size_t column = 0, double low = 1, double high = 0, bool histogram = false, NodeId node = {});
    glm::dvec3 at(uint32_t vertex, NodeId node = {});        ///< in the world
    glm::dvec3 centre(uint32_t face, NodeId node = {});      ///< of its corners
    void wires(bool on) { frame.options.wireOverlay = on; }  ///< on unless said
    void smooth(bool on = true) { frame.options.shading = on ? Shading::Smooth : Shading::Flat; }

    void arrange(const Box& place) override;
    std::optional<Picture> picture(Offscreen& offscreen, float pixelRatio) override;
    void paint(Painter& painter) override;
    glm::vec2 onPage(const At& at) const override;

private:
    NodeId last(NodeId node) const;
    Mark& mark(ElementKind kind, std::vector<uint32_t> indices, glm::vec4 color, float width, NodeId node);
    bool fixed_ = false;
    std::shared_ptr<const Material> clay_;
    friend class Page;
};

/// Rows of text. Sized by what is in it.
class TablePanel : public Panel {
public:
    struct Cell {
        std::string text;
        glm::vec4 color{0};  ///< of the text; alpha 0: as usual
        glm::vec4 ground{0};
        Cell(std::string t) : text(std::move(t)) {}
        Cell(const char* t) : text(t) {}
        Cell(std::string t, glm::vec4 c, glm::vec4 g = glm::vec4(0)) : text(std::move(t)), color(c), ground(g) {}
    };
    int fontSize = 14;
    float rowHeight = 22;
    bool numbersRight = true;
    void header(std::vector<std::string> names) { header_ = std::move(names); }
    void row(std::vector<Cell> cells) { rows_.push_back(std::move(cells)); }
    void rule() { rules_.push_back(rows_.size()); }  ///< a line before the next row

    void measure(Painter& painter) override;
    void paint(Painter& painter) override;

private:
    std::vector<std::string> header_;
    std::vector<std::vector<Cell>> rows_;
    std::vector<size_t> rules_;
    std::vector<float> widths_;
    struct Look {
        glm::vec4 text, faint, line, head;
    } look_;
    friend class Page;
};

/// Curves over axes with round ticks.
class Plot : public Panel {
public:
    std::string xTitle, yTitle;
    bool logY = false;
    std::optional<std::pair<double, double>> xRange, yRange;
    void series(std::string name, std::vector<double> x, std::vector<double> y, const Pen& pen, float discs = 0);
    void mark(double x, double y, std::string text, glm::vec4 color);

    void measure(Painter& painter) override;
    void paint(Painter& painter) override;
    glm::vec2 onPage(const At& at) const override;

private:
    void paintAxes(Painter& painter);
    struct Series {
        std::string name;
        std::vector<double> x, y;
        Pen pen;
        float discs;
    };
    std::vector<Series> series_;
    struct Marked {
        double x, y;
        std::string text;
        glm::vec4 color;
    };
    std::vector<Marked> marked_;
    std::pair<double, double> x_{0, 1}, y_{0, 1};
    Box area_;
    struct Look {
        glm::vec4 text, faint, line;
    } look_;
    friend class Page;
};

using Number = std::variant<double, bool, std::vector<double>, std::string>;

class Page {
public:
    explicit Page(Theme theme) : theme_(theme) {}

    glm::vec4 ink(Ink ink) const;
    glm::vec4 series(int i) const;                       ///< colours that tell apart
    glm::vec4 tint(glm::vec4 color, float share) const;  ///< of the panel's ground, opaque: for areas
    Theme theme() const { return theme_; }

    Space& space(std::string caption = {}, glm::vec2 size = {430, 380});
    Drawing& drawing(std::string caption = {}, glm::vec2 size = {430, 380});
    TablePanel& table(std::string caption, std::vector<std::string> header);
    Plot& plot(std::string caption, std::string xTitle, std::string yTitle, glm::vec2 size = {430, 320});
    void row() { rows_.emplace_back(); }  ///< the next panels stand below
    void letters(bool on) { letters_ = on; }
    /// An arrow from a place of one panel to a place of another.
    void link(const Panel& from, At a, const Panel& to, At b, const Pen& pen);
    void note(std::string text) { notes_.push_back(std::move(text)); }  ///< a line of text below everything

    void number(const std::string& name, Number value) { numbers_.emplace_back(name, std::move(value)); }
    template <class T>
    void number(const std::string& name, T value) requires std::is_integral_v<T> &&(!std::is_same_v<T, bool>)
    {
        numbers_.emplace_back(name, double(value));
    }
    template <class T>
    void numbers(const std::string& name, const std::vector<T>& values)
    {
        numbers_.emplace_back(name, std::vector<double>(values.begin(), values.end()));
    }

    struct Made {
        Picture picture;
        std::vector<std::string> captions;
        std::vector<std::string> outside;  ///< text that is not whole on the page
        std::vector<std::string> covered;  ///< pairs of texts that overlap
    };
    /// Lays the panels out and draws them.
    Made draw(Offscreen& offscreen, const std::string& title, float pixelRatio);
    const std::vector<std::pair<std::string, Number>>& numbers() const { return numbers_; }

private:
    template <class P>
    P& add(std::string caption);
    struct Link {
        const Panel *from, *to;
        At a, b;
        Pen pen;
    };
    struct Layout;
    void arrange(Painter& painter, Layout& layout, const std::string& title);
    void paintLegends(Painter& painter, const Panel& panel, float& y) const;
    void paintPanel(Painter& painter, Panel& panel, const Box& cell) const;
    void paintNotes(Painter& painter, glm::vec2 size) const;

    Theme theme_;
    bool letters_ = true;
    std::vector<std::vector<std::unique_ptr<Panel>>> rows_;
    std::vector<Link> links_;
    std::vector<std::string> notes_;
    std::vector<std::pair<std::string, Number>> numbers_;
};

struct Figure {
    const char* id;      ///< "2.02-cube-strip": file name, option, key
    const char* number;  ///< of the figure in the book
    const char* title;
    std::vector<std::string> proves;  ///< rows of the mission
    void (*make)(Page&);
};

/// Three significant digits, minus sign as in print.
std::string shortNumber(double v);
std::string countText(size_t n, const char* one, const char* many = nullptr);  ///< "3 faces"

}  // namespace mw::figures
