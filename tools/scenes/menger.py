"""The Menger sponge of level 2 (Karl Menger 1926), as the outer faces of its 400 cubes.

A cube of a 9 x 9 x 9 grid stays if at neither scale two or more of its coordinates are in the middle
third. Level n has 2 * 20^n + 4 * 8^n faces: 1056 here, which is 2112 triangles.
"""
SIDE = 9


def solid(cell):
    if any(c < 0 or c >= SIDE for c in cell):
        return False
    return all(sum(c // scale % 3 == 1 for c in cell) < 2 for scale in (1, 3))


def menger_obj():
    vertices, faces = {}, []
    cells = [(x, y, z) for x in range(SIDE) for y in range(SIDE) for z in range(SIDE)]
    for cell in filter(solid, cells):
        for axis in range(3):
            for side in (0, 1):
                neighbour = list(cell)
                neighbour[axis] += 2 * side - 1
                if solid(neighbour):
                    continue
                u, v = (axis + 1) % 3, (axis + 2) % 3
                corners = []
                for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    corner = list(cell)
                    corner[axis] += side
                    corner[u] += du
                    corner[v] += dv
                    corners.append(vertices.setdefault(tuple(corner), len(vertices) + 1))
                faces.append(corners if side else corners[::-1])
    assert len(faces) == 2 * 20 ** 2 + 4 * 8 ** 2
    lines = ["# Menger sponge, level 2, 9 units a side; made by tools/scenes/generate.py"]
    lines += ["v {} {} {}".format(*v) for v in vertices]
    lines += ["f {} {} {} {}".format(*f) for f in faces]
    return "\n".join(lines) + "\n"
