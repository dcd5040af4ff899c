#include "app/export_ply.h"

#include <fmt/format.h>

#include <iterator>

namespace raylab::app {

void PlyMesh::add(const Quad& quad) {
    const int first = static_cast<int>(positions.size());
    positions.insert(positions.end(), quad.v, quad.v + 4);
    faces.push_back({first, first + 1, first + 2});
    faces.push_back({first, first + 2, first + 3});
}

void PlyMesh::add(const Triangle& triangle) {
    const int first = static_cast<int>(positions.size());
    positions.insert(positions.end(), triangle.v, triangle.v + 3);
    faces.push_back({first, first + 1, first + 2});
}

void PlyMesh::add(const Triangle& triangle, const TriangleCorners& corners) {
    add(triangle);
    const Vec3 sum = corners.normal[0] + corners.normal[1] + corners.normal[2];
    const float side = copysignf(1, dot(sum, triangle.normal));
    for (const Vec3& normal : corners.normal) normals.push_back(side * normal);
    uv.insert(uv.end(), corners.uv, corners.uv + 3);
}

PlyMesh PlyMesh::back(float gap) const {
    PlyMesh mesh = *this;
    for (std::array<int, 3>& face : mesh.faces) {
        const DVec3 a(positions[face[0]]), b(positions[face[1]]), c(positions[face[2]]);
        const DVec3 normal = glm::normalize(cross(b - a, c - a));
        for (const int i : face)
            mesh.positions[i] = Vec3(DVec3(positions[i]) - double(gap) * normal);
        std::swap(face[1], face[2]);
    }
    return mesh;
}

std::string encode_ply(const PlyMesh& mesh) {
    const bool smooth = !mesh.normals.empty();
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "ply\nformat ascii 1.0\nelement vertex {}\n", mesh.positions.size());
    text += "property float x\nproperty float y\nproperty float z\n";
    if (smooth) text += "property float nx\nproperty float ny\nproperty float nz\n";
    if (smooth) text += "property float u\nproperty float v\n";
    fmt::format_to(out, "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                   mesh.faces.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 p = mesh.positions[i];
        fmt::format_to(out, "{} {} {}", p.x, p.y, p.z);
        if (smooth) {
            const Vec3 n = mesh.normals[i];
            fmt::format_to(out, " {} {} {} {} {}", n.x, n.y, n.z, mesh.uv[i].x, mesh.uv[i].y);
        }
        text += '\n';
    }
    for (const std::array<int, 3>& f : mesh.faces)
        fmt::format_to(out, "3 {} {} {}\n", f[0], f[1], f[2]);
    return text;
}

} // namespace raylab::app
