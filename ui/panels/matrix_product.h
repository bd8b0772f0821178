// Where a node stands as a product of matrices, from its root down to itself: each factor a fold, then what they multiply to.
#pragma once
#include <QWidget>
#include <vector>

#include "ui/session.h"

class QLabel;
class QVBoxLayout;

namespace mw {

class Fold;

class MatrixProduct : public QWidget {
    Q_OBJECT

public:
    MatrixProduct(Session& session, QWidget* parent);
    void setNode(NodeId id);
    void refresh();  ///< the numbers at the playhead; cheap for what is shut

private:
    struct Factor {
        NodeId node;
        Fold* fold;
        QLabel* numbers;
    };
    void rebuild();
    Factor factor(const QString& title, const QString& key, bool open, NodeId node);
    void write(const Factor& f, const glm::dmat4& m, const QString& note = {});

    Session& session_;
    NodeId node_;
    std::vector<NodeId> chain_;  // root first
    std::vector<Factor> factors_;
    Factor product_{}, offset_{};
    QLabel* formula_ = nullptr;
    QVBoxLayout* box_;
};

}  // namespace mw
