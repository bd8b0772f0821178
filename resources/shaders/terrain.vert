// Passes a patch's corner on; corners are whole numbers, so that neighbours have the very same ones.
layout(location = 0) in vec4 control;  // column, row, level of the edge with this number, inner level
out vec4 corner;
void main() { corner = control; }
