// The small node with SDO block transfers.
#include "bench/size/writable_pdos.hpp"

using Node = canvoy::SmallNode<canvoy::node_tables, true>;

constinit static Node::Device::Memory the_memory{};
constinit static Node the_node(the_memory);

int main() {
  the_node.run();
}
