// OpenSubdiv's uniform refinement of our meshes: faces of any size, creases, face-varying values.
#pragma once
#include <memory>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>
#include <vector>

#include "core/mesh/mesh.h"

namespace mw::test {

namespace osd = OpenSubdiv;

struct OsdPoint {
    double x = 0, y = 0, z = 0;
    void Clear() { x = y = z = 0; }
    void AddWithWeight(const OsdPoint& p, float w)
    {
        x += double(w) * p.x;
        y += double(w) * p.y;
        z += double(w) * p.z;
    }
};

/// The face-varying values of a mesh as numbers of distinct ones at each vertex.
struct FaceVarying {
    std::vector<int> index;
    std::vector<OsdPoint> values;
};

struct OsdMesh {
    std::unique_ptr<osd::Far::TopologyRefiner> refiner;

    /// Creases of sharpness 10 are infinite. `lasting`: 1 and more counts as infinite.
    OsdMesh(const Mesh& mesh, osd::Sdc::SchemeType scheme, int levels, bool lasting = true, const FaceVarying* values = nullptr,
            osd::Sdc::Options::FVarLinearInterpolation linear = osd::Sdc::Options::FVAR_LINEAR_NONE)
    {
        std::vector<int> sizes, vertices(mesh.cornerVertex().begin(), mesh.cornerVertex().end()), creases;
        std::vector<float> weights;
        const Attribute* c = mesh.find("crease", Domain::Corner);
        for (size_t f = 0; f < mesh.faceCount(); ++f) {
            const auto face = mesh.face(f);
            sizes.push_back(int(face.size()));
            for (size_t k = 0; c && k < face.size(); ++k)
                if (const double s = c->at(mesh.faceStart()[f] + k, 0); s > 0) {
                    creases.insert(creases.end(), {int(face[k]), int(face[(k + 1) % face.size()])});
                    weights.push_back(lasting && s >= 1 ? 10.f : float(s));
                }
        }
        osd::Far::TopologyDescriptor d;
        d.numVertices = int(mesh.vertexCount());
        d.numFaces = int(mesh.faceCount());
        d.numVertsPerFace = sizes.data();
        d.vertIndicesPerFace = vertices.data();
        d.numCreases = int(weights.size());
        d.creaseVertexIndexPairs = creases.data();
        d.creaseWeights = weights.data();
        osd::Far::TopologyDescriptor::FVarChannel channel;
        if (values) {
            channel.numValues = int(values->values.size());
            channel.valueIndices = values->index.data();
            d.numFVarChannels = 1;
            d.fvarChannels = &channel;
        }
        osd::Sdc::Options options;
        options.SetVtxBoundaryInterpolation(osd::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
        options.SetFVarLinearInterpolation(linear);
        using Factory = osd::Far::TopologyRefinerFactory<osd::Far::TopologyDescriptor>;
        refiner.reset(Factory::Create(d, Factory::Options(scheme, options)));
        osd::Far::TopologyRefiner::UniformOptions uniform(levels);
        uniform.fullTopologyInLastLevel = true;
        refiner->RefineUniform(uniform);
    }
    std::vector<OsdPoint> positions(const Mesh& mesh, int level) const
    {
        const osd::Far::PrimvarRefiner primvar(*refiner);
        std::vector<OsdPoint> points;
        for (const glm::vec3& p : mesh.positions()) points.push_back({p.x, p.y, p.z});
        for (int n = 1; n <= level; ++n) {
            std::vector<OsdPoint> next(size_t(refiner->GetLevel(n).GetNumVertices()));
            primvar.Interpolate(n, points, next);
            points.swap(next);
        }
        return points;
    }
    std::vector<OsdPoint> faceVarying(std::vector<OsdPoint> values, int level) const
    {
        const osd::Far::PrimvarRefiner primvar(*refiner);
        for (int n = 1; n <= level; ++n) {
            std::vector<OsdPoint> next(size_t(refiner->GetLevel(n).GetNumFVarValues(0)));
            primvar.InterpolateFaceVarying(n, values, next, 0);
            values.swap(next);
        }
        return values;
    }
};

}  // namespace mw::test
