// Which node is seen; where on it is found on the processor.
out uvec2 id;
void main() { id = uvec2(ids.x, 0xffffffffu); }
