// What an algorithm would be stepped on right now: the selected mesh or character, or what its lesson is tried on.
#pragma once
#include <QString>

#include "ui/session.h"

namespace mw {

struct StepSubject {
    NodeId node;  ///< whose mesh or skeleton it is; none: the value stands by itself, in a lab
    Value value;
    ParameterValues values;  ///< with what follows from the subject: the end joint, the target
    QString name;            ///< "bunny", "joint chain"
    QString whyNot;          ///< why it cannot be stepped; empty when it can
};

/// For menus: without the value, which may cost something.
QString whyNotSteppable(const Session& session, const Operation& op);
/// Whose mesh or skeleton it would be; none: a lab.
NodeId subjectNode(const Session& session, const Operation& op);
/// At the selection and the playhead. `values` are those the person gave.
StepSubject stepSubject(const Session& session, const Operation& op, ParameterValues values = {});

/// The topmost joint of the character that a node is of: a joint, a skinned mesh, or something above them. None: no character.
NodeId characterOf(const Scene& scene, NodeId node);
/// Where the scene stands: its clip at the playhead, and on top of that the pose that is being stepped.
ScenePose shownPose(const Session& session, const ScenePose& played);

}  // namespace mw
